#include "outbox.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "closures.hpp"
#include "contact_memory.hpp"
#include "exchange_columns.hpp"
#include "tags.hpp"

namespace slidewave {
namespace {

/// Of `memory`, behind the ledger.
constexpr int home_row = 3;

/// Given less received [kg m/s].
void pack_ledger(Table const& particles, Vec3 const& in_plane, int const* rows, long count,
                 double* out) {
  auto const given = particles["memory"], received = particles["impulse"];
  for (long k = 0; k < count; ++k) {
    Eigen::Map<Vec3>(out + 3 * k) =
        in_plane.cwiseProduct(given.col(rows[k]).head<3>() - received.col(rows[k]));
  }
}

/// The cell where the particle was, if that was on the rank that it goes to.
void pack_hints(Table const& particles, int destination, int const* rows, long count, double* out) {
  auto const memory = particles["memory"];
  for (long k = 0; k < count; ++k) {
    HomeCode const home = HomeCode::decode(memory(home_row, rows[k]));
    out[k] = home.owner == destination ? home.cell : -1;
  }
}

}  // namespace

Outbox::Outbox(Session::Impl& session, Agreed const& agreed)
    : session_(session),
      agreed_(agreed),
      map_(agreed.fluid_boxes),
      channel_(session),
      sender_(session.world, session.waiter),
      answered_(Layout::answered(agreed.models)) {
  if (agreed.models.stiff) {
    derived_.add({"other_force", "N", 3});
    derived_.add({"stiffness", "N/m", 1});
    derived_.add({"solid_velocity", "m/s", 3});
    windows_ = Windows::of(session.scene);
    gravity_m_s2_ = session.scene.vector("physics.gravity");
  }
}

Vec3 Outbox::ledger(Table const& particles) const {
  auto const given = particles["memory"], received = particles["impulse"];
  Vec3 sum = Vec3::Zero();
  for (long i = 0; i < particles.size(); ++i) {
    sum += given.col(i).head<3>() - received.col(i);
  }
  return agreed_.in_plane.cwiseProduct(sum);
}

void Outbox::choose_destinations(Table const& particles) {
  auto const position = particles["position"];
  auto const radius = particles["radius"];
  auto const memory = particles["memory"];
  owner_.resize(particles.size());
  for (long i = 0; i < particles.size(); ++i) {
    owner_[i] = homes_known_ ? HomeCode::decode(memory(home_row, i)).owner : -1;
    if (owner_[i] < 0 || owner_[i] >= session_.world.partner_size) {
      owner_[i] = map_.first(position.col(i), radius(0, i));
    }
  }
  groups_.sort(owner_, session_.world.partner_size);
}

void Outbox::pack_field(Table const& particles, Field const& field, int destination,
                        int const* rows, long count, double* out) const {
  if (field.name == "ledger") {
    pack_ledger(particles, agreed_.in_plane, rows, count, out);
  } else if (field.name == "cell_hint") {
    pack_hints(particles, homes_known_ ? destination : -1, rows, count, out);
  } else {
    Table const& source = derived_.has(field.name) ? derived_ : particles;
    pack(source[field.name], rows, count, out);
  }
}

void Outbox::pack_rows(Table const& particles, int const* rows, long count, int destination,
                       double* out) const {
  for (Field const& field : agreed_.layout.to_fluid) {
    out = pack_block(
        count, field.components, out,
        [&](long begin, long some, double* to) {
          pack_field(particles, field, destination, rows + begin, some, to);
        },
        [&](long bad) {
          session_.failure.fail(fmt::format("'{}' of the particle at {} is not a finite number",
                                            field.name, place_of(particles, rows[bad])),
                                1);
        });
  }
}

Wishes Outbox::send(Table const& particles, long window, Wishes mine) {
  Scope const scope(session_.profile, Phase::exchange);
  if (agreed_.models.stiff) {
    double const last_s = window > 0 ? (*windows_)[window - 1].length_s() : 0;
    recall_contacts(particles, last_s, gravity_m_s2_, derived_);
  }
  choose_destinations(particles);
  int const width = doubles_per_particle(agreed_.layout.to_fluid);
  buffers_.resize(std::max<std::size_t>(buffers_.size(), groups_.size()));
  for (int g = 0; g < groups_.size(); ++g) {
    std::vector<double>& buffer = buffers_[g];
    buffer.resize(header_size + width * groups_.count(g));
    buffer[0] = stamp(window, tag::particles);
    buffer[1] = static_cast<double>(groups_.count(g));
    pack_rows(particles, groups_.rows(g), groups_.count(g), groups_.destination(g),
              buffer.data() + header_size);
    sender_.send(groups_.destination(g), buffer, tag::particles);
  }
  sender_.finish("the particles");

  double common[3] = {0, mine.stop ? 1.0 : 0.0, mine.checkpoint ? 1.0 : 0.0};  // first: misses
  session_.agreement.sum_all(common, 3, "fluid: to locate the particles");
  misses_.clear();
  census_ = {};
  if (common[0] > 0) {
    read_misses(particles, window);
    query_others(particles, window);
    send_moves(particles, window);
  }
  homes_known_ = true;
  expect_answers();
  judge_outside(particles, window);
  return {common[1] > 0, common[2] > 0};
}

void Outbox::judge_outside(Table const& particles, long window) {
  auto const radius = particles["radius"];
  long first_outside = -1;
  for (long i = 0; i < particles.size(); ++i) {
    if (owner_[i] >= 0) {
      census_.volume_m3 += volume_of(radius(0, i));
    } else {
      first_outside = census_.outside++ == 0 ? i : first_outside;
    }
  }
  if (census_.outside == 0 || agreed_.models.outside == Outside::ignore) {
    return;
  }
  double distance_m = map_.distance_m(particles["position"].col(first_outside));
  for (Miss const& miss : misses_) {
    if (miss.row == first_outside && miss.distance_m < nowhere_m) {
      distance_m = miss.distance_m;  // from the nearest cell, where one was asked
    }
  }
  std::string const text = fmt::format(
      "{} particle(s) outside the fluid mesh at window {}, the first at {}, {:.3g} m beyond it",
      census_.outside, window, place_of(particles, first_outside), distance_m);
  if (agreed_.models.outside == Outside::error) {
    session_.failure.fail(
        text + "; enlarge the mesh, or set coupling.outside to \"warn\" or \"ignore\"", 1);
  }
  if (census_.outside > most_outside_) {
    most_outside_ = 2 * census_.outside;  // speak again when it has doubled
    session_.failure.terminal().say("slidewave: warning: " + text);
  }
}

void Outbox::expect_answers() {
  expected_count_ = 0;
  expected_.resize(std::max<std::size_t>(expected_.size(), groups_.size()));
  for (int g = 0; g < groups_.size(); ++g) {
    Expected& expected = expected_[expected_count_];
    expected.rank = groups_.destination(g);
    expected.rows.clear();
    for (long k = 0; k < groups_.count(g); ++k) {
      int const row = groups_.rows(g)[k];
      if (owner_[row] == expected.rank) {
        expected.rows.push_back(row);
      }
    }
    ++expected_count_;
  }
  for (Miss const& miss : misses_) {
    if (miss.winner < 0 || miss.winner == miss.tried) {
      continue;
    }
    std::size_t k = 0;
    while (k < expected_count_ && expected_[k].rank != miss.winner) {
      ++k;
    }
    if (k == expected_count_) {
      expected_.resize(std::max(expected_.size(), ++expected_count_));
      expected_[k].rank = miss.winner;
      expected_[k].rows.clear();
    }
    expected_[k].rows.push_back(miss.row);
  }
}

bool Outbox::all_answered() const {
  std::size_t rows = 0;
  for (std::size_t e = 0; e < expected_count_; ++e) {
    rows += expected_[e].rows.size();
  }
  return rows == owner_.size();
}

void Outbox::receive(Table const& particles, Table& answers, long window) {
  auto memory = answers["memory"];
  if (!all_answered()) {
    for (Field const& field : answered_) {
      if (field.name != "memory") {
        answers[field.name].setZero();
      }
    }
    memory.row(home_row).setZero();
  }
  if (agreed_.models.ledger()) {
    auto const kept = particles["memory"];
    auto const received = particles["impulse"];
    for (long i = 0; i < answers.size(); ++i) {
      memory.col(i).head<3>() =
          agreed_.in_plane.cwiseProduct(kept.col(i).head<3>() - received.col(i));
    }
  }
  if (agreed_.models.stiff) {
    keep_contacts(derived_, answers);
  }
  Phase phase = Phase::wait;
  buffers_.resize(std::max(buffers_.size(), expected_count_));  // what they held was taken
  for (std::size_t e = 0; e < expected_count_; ++e) {
    auto const& [rank, rows] = expected_[e];
    if (rows.empty()) {
      continue;
    }
    std::vector<double>& incoming = buffers_[e];
    channel_.receive(rank, tag::answers, window, incoming, "answers", phase);
    phase = Phase::exchange;
    long const count = static_cast<long>(rows.size());
    double const* in = incoming.data() + header_size;
    for (Field const& field : agreed_.layout.to_dem) {
      if (field.name == "cell") {
        for (long k = 0; k < count; ++k) {
          memory(home_row, rows[k]) = HomeCode{rank, static_cast<int>(in[k])}.encode();
        }
      } else if (field.name == "given") {
        for (long k = 0; k < count; ++k) {
          memory.col(rows[k]).head<3>() +=
              agreed_.in_plane.cwiseProduct(Eigen::Map<Vec3 const>(in + 3 * k));
        }
      } else {
        unpack(in, rows.data(), count, answers[field.name]);
      }
      in += count * field.components;
    }
  }
}

}  // namespace slidewave
