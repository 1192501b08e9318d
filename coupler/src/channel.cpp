#include "channel.hpp"

#include <fmt/format.h>

namespace slidewave {

void Channel::send(int rank, std::vector<double> const& buffer, int tag) {
  MPI_Isend(buffer.data(), static_cast<int>(buffer.size()), MPI_DOUBLE, rank, tag,
            session_.world.inter, &requests_.emplace_back());
}

void Channel::finish(char const* what) {
  session_.waiter.until(
      [this] {
        int done = 0;
        MPI_Testall(static_cast<int>(requests_.size()), requests_.data(), &done,
                    MPI_STATUSES_IGNORE);
        return done != 0;
      },
      [&] { return fmt::format("{}: to take {}", name_of(other(session_.role)), what); },
      Phase::exchange);
  requests_.clear();
}

void Channel::receive(int rank, int tag, long window, std::vector<double>& buffer, char const* what,
                      Phase counted_as) {
  auto const awaited = [&] {
    return fmt::format("{} rank {}: {} of window {}", name_of(other(session_.role)), rank, what,
                       window);
  };
  MPI_Message message;
  MPI_Status status;
  session_.waiter.until(
      [&] {
        int found = 0;
        MPI_Improbe(rank, tag, session_.world.inter, &found, &message, &status);
        return found != 0;
      },
      awaited, counted_as);
  int size = 0;
  MPI_Get_count(&status, MPI_DOUBLE, &size);
  buffer.resize(size);
  MPI_Request request;
  MPI_Imrecv(buffer.data(), size, MPI_DOUBLE, &message, &request);
  session_.waiter.until(
      [&] {
        int done = 0;
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        return done != 0;
      },
      awaited, Phase::exchange);
  rows_of(buffer, window, tag, rank);
}

long Channel::rows_of(std::vector<double> const& buffer, long window, int tag, int source) const {
  if (buffer.size() < header_size || buffer[0] != stamp(window, tag)) {
    session_.failure.fail(
        fmt::format("lost step: a message of kind {} from {} rank {} does not belong to window {}",
                    tag, name_of(other(session_.role)), source, window),
        1);
  }
  return static_cast<long>(buffer[1]);
}

}  // namespace slidewave
