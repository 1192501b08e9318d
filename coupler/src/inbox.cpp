#include "inbox.hpp"

#include <fmt/format.h>

#include <cstring>

#include "exchange_columns.hpp"
#include "tags.hpp"

namespace slidewave {
namespace {

/// Where the block of a field begins in a message of `rows` particles.
long block_of(std::vector<Field> const& fields, std::string const& name, long rows) {
  long offset = 0;
  for (Field const& field : fields) {
    if (field.name == name) {
      break;
    }
    offset += rows * field.components;
  }
  return offset;
}

}  // namespace

Inbox::Inbox(Session::Impl& session, Agreed const& agreed)
    : session_(session),
      agreed_(agreed),
      channel_(session),
      particles_(session.world, session.waiter),
      queries_(session.world, session.waiter),
      moves_(session.world, session.waiter) {}

Wishes Inbox::collect(FluidEngine& engine, Table& particles, std::vector<int>& cell, long window,
                      Wishes mine) {
  Scope const scope(session_.profile, Phase::exchange);
  auto const& messages = particles_.collect(tag::particles, "the particles");
  batch_count_ = messages.size();
  batches_.resize(std::max(batches_.size(), batch_count_));
  for (std::size_t b = 0; b < batch_count_; ++b) {
    batches_[b].message = messages[b];
    batches_[b].rows =
        channel_.rows_of(messages[b]->data, window, tag::particles, messages[b]->source);
  }
  locate(engine, window);
  double common[3] = {0, mine.stop ? 1.0 : 0.0, mine.checkpoint ? 1.0 : 0.0};  // first: misses
  for (std::size_t b = 0; b < batch_count_; ++b) {
    common[0] += batches_[b].misses[1];
  }
  session_.agreement.sum_all(common, 3, "all ranks to locate the particles");
  moved_.clear();
  if (common[0] > 0) {
    for (std::size_t b = 0; b < batch_count_; ++b) {
      channel_.send(batches_[b].message->source, batches_[b].misses, tag::misses);
    }
    answer_queries(engine, window);
    read_moves(window);
  }
  build(engine, particles, cell);
  return {common[1] > 0, common[2] > 0};
}

void Inbox::locate(FluidEngine& engine, long window) {
  Scope const scope(session_.profile, Phase::locate);
  for (std::size_t b = 0; b < batch_count_; ++b) {
    Batch& batch = batches_[b];
    double const* body = batch.message->data.data() + header_size;
    double const* hint = body + block_of(agreed_.layout.to_fluid, "cell_hint", batch.rows);
    batch.cell.resize(batch.rows);
    batch.stays.assign(batch.rows, 1);
    batch.misses.assign({stamp(window, tag::misses), 0});
    for (long i = 0; i < batch.rows; ++i) {
      Eigen::Map<Vec3 const> const point(body + 3 * i);
      Home const home = engine.locate(point, static_cast<int>(hint[i]));
      batch.cell[i] = home.cell;
      if (home.cell < 0 || home.distance_m > 0) {
        batch.stays[i] = 0;
        batch.misses[1] += 1;
        batch.misses.push_back(static_cast<double>(i));
        batch.misses.push_back(home.cell < 0 ? nowhere_m : home.distance_m);
      }
    }
  }
}

void Inbox::copy_rows(Incoming const& message, long offset, long rows,
                      std::vector<char> const* stays, Table& particles, long begin) const {
  double const* in = message.data.data() + offset;
  for (Field const& field : agreed_.layout.to_fluid) {
    int const width = field.components;
    if (field.name == "cell_hint") {  // has done its work
      in += rows;
      continue;
    }
    double* out = particles[field.name].data() + begin * width;
    if (!stays) {
      std::memcpy(out, in, sizeof(double) * width * rows);
    } else {
      for (long i = 0; i < rows; ++i) {
        if ((*stays)[i]) {
          std::memcpy(out, in + i * width, sizeof(double) * width);
          out += width;
        }
      }
    }
    in += rows * width;
  }
}

void Inbox::build(FluidEngine& engine, Table& particles, std::vector<int>& cell) {
  spans_.clear();
  long total = 0;
  for (std::size_t b = 0; b < batch_count_; ++b) {
    total += batches_[b].rows;
  }
  for (Incoming const* message : moved_) {
    total += static_cast<long>(message->data[1]);
  }
  particles.resize(total);
  cell.clear();
  int const width = doubles_per_particle(agreed_.layout.to_fluid);
  std::size_t b = 0;
  std::size_t m = 0;
  while (b < batch_count_ || m < moved_.size()) {  // both are sorted by source
    int const from_batch = b < batch_count_ ? batches_[b].message->source : 1 << 30;
    int const from_moved = m < moved_.size() ? moved_[m]->source : 1 << 30;
    int const source = std::min(from_batch, from_moved);
    long const begin = static_cast<long>(cell.size());
    std::vector<double>* buffer = nullptr;
    if (from_batch == source) {
      Batch const& batch = batches_[b++];
      buffer = &batch.message->data;
      bool const all = batch.misses[1] == 0;
      copy_rows(*batch.message, header_size, batch.rows, all ? nullptr : &batch.stays, particles,
                begin);
      for (long i = 0; i < batch.rows; ++i) {
        if (batch.stays[i]) {
          cell.push_back(batch.cell[i]);
        }
      }
    }
    if (from_moved == source) {
      Incoming& message = *moved_[m++];
      buffer = buffer ? buffer : &message.data;
      long const rows = static_cast<long>(message.data[1]);
      long const offset = static_cast<long>(message.data.size()) - width * rows;
      copy_rows(message, offset, rows, nullptr, particles, static_cast<long>(cell.size()));
      for (long i = 0; i < rows; ++i) {
        Eigen::Map<Vec3 const> const point(message.data.data() + offset + 3 * i);
        cell.push_back(engine.locate(point, -1).cell);
      }
    }
    long const rows = static_cast<long>(cell.size()) - begin;
    if (rows > 0) {
      spans_.push_back({source, begin, rows, buffer});
    }
  }
  particles.resize(static_cast<long>(cell.size()));
}

void Inbox::answer(Table const& answers, std::vector<int> const& cell, long window) {
  Scope const scope(session_.profile, Phase::exchange);
  int const width = doubles_per_particle(agreed_.layout.to_dem);
  for (Span const& span : spans_) {
    std::vector<double>& buffer = *span.buffer;
    buffer.resize(header_size + width * span.rows);
    buffer[0] = stamp(window, tag::answers);
    buffer[1] = static_cast<double>(span.rows);
    double* out = buffer.data() + header_size;
    for (Field const& field : agreed_.layout.to_dem) {
      if (field.name == "cell") {
        std::copy_n(cell.begin() + span.begin, span.rows, out);
      } else {
        long const count = span.rows * field.components;
        std::memcpy(out, answers[field.name].data() + span.begin * field.components,
                    sizeof(double) * count);
        if (!all_finite(out, count)) {
          long bad = 0;
          while (all_finite(out + bad * field.components, field.components)) {
            ++bad;
          }
          session_.failure.fail(fmt::format("'{}' for the particle at {} is not a finite number",
                                            field.name, place_of(answers, span.begin + bad)),
                                1);
        }
      }
      out += span.rows * field.components;
    }
    channel_.send(span.source, buffer, tag::answers);
  }
  channel_.finish("the answers");
}

}  // namespace slidewave
