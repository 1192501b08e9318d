// What a fluid rank does about particles that were sent to the wrong rank (see outbox_misses.cpp).
#include "inbox.hpp"
#include "tags.hpp"

namespace slidewave {

void Inbox::answer_queries(FluidEngine& engine, long window) {
  auto const& queries = queries_.collect(tag::queries, "queries about missed particles");
  std::vector<std::vector<double>> distances(queries.size());
  for (std::size_t q = 0; q < queries.size(); ++q) {
    long const rows = channel_.rows_of(queries[q]->data, window, tag::queries, queries[q]->source);
    distances[q] = {stamp(window, tag::distances), static_cast<double>(rows)};
    for (long i = 0; i < rows; ++i) {
      Eigen::Map<Vec3 const> const point(queries[q]->data.data() + header_size + 3 * i);
      Home const home = engine.locate(point, -1);
      distances[q].push_back(home.cell < 0 ? nowhere_m : home.distance_m);
    }
    channel_.send(queries[q]->source, distances[q], tag::distances);
  }
  channel_.finish("distances");
}

void Inbox::read_moves(long window) {
  moved_ = moves_.collect(tag::moves, "moved particles");
  int const width = doubles_per_particle(agreed_.layout.to_fluid);
  for (Incoming const* message : moved_) {
    long const rows = channel_.rows_of(message->data, window, tag::moves, message->source);
    long const kept = static_cast<long>(message->data.size()) - header_size - width * rows;
    for (long k = 0; k < kept; ++k) {
      int const index = static_cast<int>(message->data[header_size + k]);
      for (std::size_t b = 0; b < batch_count_; ++b) {
        if (batches_[b].message->source == message->source) {
          batches_[b].stays[index] = 1;
        }
      }
    }
  }
}

}  // namespace slidewave
