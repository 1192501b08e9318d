#include "sparse.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace slidewave {
namespace {

bool all_done(std::vector<MPI_Request>& requests) {
  int done = 0;
  MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
  return done != 0;
}

}  // namespace

void SparseSender::send(int fluid_rank, std::vector<double> const& buffer, int tag) {
  MPI_Issend(buffer.data(), static_cast<int>(buffer.size()), MPI_DOUBLE, fluid_rank, tag,
             world_.inter, &requests_.emplace_back());
}

void SparseSender::finish(char const* what) {
  auto const awaited = [what] { return fmt::format("fluid: to take {}", what); };
  waiter_.until([this] { return all_done(requests_); }, awaited);
  requests_.clear();
  MPI_Request barrier;
  MPI_Ibarrier(world_.all, &barrier);
  waiter_.request(barrier, awaited);
}

void SparseReceiver::take_arrived(int tag) {
  for (;;) {
    int found = 0;
    MPI_Message message;
    MPI_Status status;
    MPI_Improbe(MPI_ANY_SOURCE, tag, world_.inter, &found, &message, &status);
    if (!found) {
      return;
    }
    int size = 0;
    MPI_Get_count(&status, MPI_DOUBLE, &size);
    if (arrived_.size() == pool_.size()) {
      pool_.emplace_back();
    }
    Incoming& incoming = pool_[arrived_.size()];
    incoming.source = status.MPI_SOURCE;
    incoming.data.resize(size);
    arrived_.push_back(&incoming);
    MPI_Imrecv(incoming.data.data(), size, MPI_DOUBLE, &message, &requests_.emplace_back());
  }
}

std::vector<Incoming*> const& SparseReceiver::collect(int tag, char const* what) {
  arrived_.clear();
  requests_.clear();
  MPI_Request barrier;
  MPI_Ibarrier(world_.all, &barrier);
  bool senders_done = false;
  auto const step = [&] {
    take_arrived(tag);
    if (!senders_done) {
      int done = 0;
      MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
      senders_done = done != 0;
    }
    return senders_done;
  };
  auto const awaited = [what] { return fmt::format("dem: {}", what); };
  waiter_.until([&] { return step() || !arrived_.empty(); }, awaited);
  waiter_.until([&] { return step(); }, awaited, Phase::exchange);
  waiter_.until([&] { return all_done(requests_); }, awaited, Phase::exchange);
  std::sort(arrived_.begin(), arrived_.end(),
            [](Incoming const* a, Incoming const* b) { return a->source < b->source; });
  return arrived_;
}

}  // namespace slidewave
