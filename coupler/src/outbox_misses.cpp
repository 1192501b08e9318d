// Particles whose likely owner was not the owner: asks the other candidates and decides. The least
// distance wins, ties go to the lowest rank; a centre farther out than its radius has no owner.
#include <cmath>
#include <limits>
#include <map>

#include "outbox.hpp"
#include "tags.hpp"

namespace slidewave {

void Outbox::read_misses(Table const&, long window) {
  for (int g = 0; g < groups_.size(); ++g) {
    int const rank = groups_.destination(g);
    channel_.receive(rank, tag::misses, window, incoming_, "misses", Phase::exchange);
    for (std::size_t k = header_size; k + 1 < incoming_.size(); k += 2) {
      int const index = static_cast<int>(incoming_[k]);
      misses_.push_back({groups_.rows(g)[index], index, rank, rank, incoming_[k + 1]});
    }
  }
}

void Outbox::query_others(Table const& particles, long window) {
  struct Query {
    std::vector<double> points;
    std::vector<std::size_t> misses;
  };
  std::map<int, Query> queries;
  std::vector<int> ranks;
  auto const position = particles["position"];
  auto const radius = particles["radius"];
  for (std::size_t m = 0; m < misses_.size(); ++m) {
    Vec3 const point = position.col(misses_[m].row);
    map_.others(point, radius(0, misses_[m].row), misses_[m].tried, ranks);
    for (int rank : ranks) {
      Query& query = queries[rank];
      if (query.points.empty()) {
        query.points = {stamp(window, tag::queries), 0};
      }
      query.points.insert(query.points.end(), point.data(), point.data() + 3);
      query.points[1] += 1;
      query.misses.push_back(m);
    }
  }
  for (auto const& [rank, query] : queries) {
    sender_.send(rank, query.points, tag::queries);
  }
  sender_.finish("queries about missed particles");
  for (auto const& [rank, query] : queries) {
    channel_.receive(rank, tag::distances, window, incoming_, "distances", Phase::exchange);
    for (std::size_t k = 0; k < query.misses.size(); ++k) {
      Miss& miss = misses_[query.misses[k]];
      double const distance = incoming_[header_size + k];
      if (distance < miss.distance_m || (distance == miss.distance_m && rank < miss.winner)) {
        miss.distance_m = distance;
        miss.winner = rank;
      }
    }
  }
  for (Miss& miss : misses_) {
    if (miss.distance_m > radius(0, miss.row)) {
      miss.winner = -1;
    }
    census_.nearest_cell += miss.winner >= 0 && miss.distance_m > 0;
    owner_[miss.row] = miss.winner;
  }
}

void Outbox::send_moves(Table const& particles, long window) {
  struct Move {
    std::vector<double> kept;  ///< indices in the first message of those that stay after all
    std::vector<int> rows;
    std::vector<double> buffer;
  };
  std::map<int, Move> moves;
  for (Miss const& miss : misses_) {
    if (miss.winner >= 0 && miss.winner == miss.tried) {
      moves[miss.winner].kept.push_back(miss.index);
    } else if (miss.winner >= 0) {
      moves[miss.winner].rows.push_back(miss.row);
    }
  }
  int const width = doubles_per_particle(agreed_.layout.to_fluid);
  for (auto& [rank, move] : moves) {
    std::size_t const rows = move.rows.size();
    move.buffer = {stamp(window, tag::moves), static_cast<double>(rows)};
    move.buffer.insert(move.buffer.end(), move.kept.begin(), move.kept.end());
    std::size_t const begin = move.buffer.size();
    move.buffer.resize(begin + width * rows);
    pack_rows(particles, move.rows.data(), static_cast<long>(rows), rank,
              move.buffer.data() + begin);
    sender_.send(rank, move.buffer, tag::moves);
  }
  sender_.finish("moved particles");
}

}  // namespace slidewave
