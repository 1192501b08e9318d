#include "inbox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

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
  list_parts(engine, cell);
  sort_by_cell(cell);
  particles.resize(static_cast<long>(cell.size()));
  for (Part const& part : parts_) {
    copy_rows(part, particles);
  }
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

void Inbox::list_parts(FluidEngine& engine, std::vector<int>& cell) {
  parts_.clear();
  spans_.clear();
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
      parts_.push_back({batch.message, header_size, batch.rows,
                        batch.misses[1] == 0 ? nullptr : &batch.stays, begin});
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
      parts_.push_back({&message, offset, rows, nullptr, static_cast<long>(cell.size())});
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
}

// A counting sort, stable.
void Inbox::sort_by_cell(std::vector<int>& cell) {
  place_.resize(cell.size());
  if (cell.empty()) {
    return;
  }
  next_.assign(*std::max_element(cell.begin(), cell.end()) + 2, 0);
  for (int const c : cell) {
    ++next_[c + 1];
  }
  std::partial_sum(next_.begin(), next_.end(), next_.begin());
  for (std::size_t i = 0; i < cell.size(); ++i) {
    place_[i] = next_[cell[i]]++;
  }
  std::size_t row = 0;  // next_ is now the end of each cell
  for (std::size_t c = 0; row < cell.size(); ++c) {
    for (; row < static_cast<std::size_t>(next_[c]); ++row) {
      cell[row] = static_cast<int>(c);
    }
  }
}

void Inbox::copy_rows(Part const& part, Table& particles) const {
  double const* in = part.message->data.data() + part.offset;
  for (Field const& field : agreed_.layout.to_fluid) {
    if (field.name != "cell_hint") {  // has done its work
      unpack(in, place_.data() + part.begin, part.rows, particles[field.name],
             part.stays ? part.stays->data() : nullptr);
    }
    in += part.rows * field.components;
  }
}

void Inbox::answer(Table const& answers, std::vector<int> const& cell, long window) {
  Scope const scope(session_.profile, Phase::exchange);
  int const width = doubles_per_particle(agreed_.layout.to_dem);
  for (Span const& span : spans_) {
    std::vector<double>& buffer = *span.buffer;
    buffer.resize(header_size + width * span.rows);
    buffer[0] = stamp(window, tag::answers);
    buffer[1] = static_cast<double>(span.rows);
    pack_answers(answers, cell, place_.data() + span.begin, span.rows, buffer.data() + header_size);
    channel_.send(span.source, buffer, tag::answers);
  }
  channel_.finish("the answers");
}

void Inbox::pack_answers(Table const& answers, std::vector<int> const& cell, int const* rows,
                         long count, double* out) const {
  for (Field const& field : agreed_.layout.to_dem) {
    if (field.name == "cell") {
      out = std::transform(rows, rows + count, out, [&](int row) { return cell[row]; });
      continue;
    }
    out = pack_block(
        count, field.components, out,
        [&](long begin, long some, double* to) {
          pack(answers[field.name], rows + begin, some, to);
        },
        [&](long bad) {
          session_.failure.fail(fmt::format("'{}' for the particle at {} is not a finite number",
                                            field.name, place_of(answers, rows[bad])),
                                1);
        });
  }
}

}  // namespace slidewave
