// Point-to-point messages on the intercommunicator, with a header that catches lost lockstep.
#pragma once

#include <vector>

#include "session_impl.hpp"

namespace slidewave {

/// The first two numbers of every message: which window and kind, and how many rows follow.
constexpr int header_size = 2;
/// The distance to a rank that has no cell at all [m].
constexpr double nowhere_m = 1e300;
inline double stamp(long window, int tag) {
  return static_cast<double>(window * 16 + tag);
}

class Channel {
 public:
  explicit Channel(Session::Impl& session) : session_(session) {}
  /// The buffer stays untouched until finish().
  void send(int rank, std::vector<double> const& buffer, int tag);
  void finish(char const* what);
  /// Waits for the message of `rank`; `counted_as` is transfer once the other side is known to
  /// send.
  void receive(int rank, int tag, long window, std::vector<double>& buffer, char const* what,
               Phase counted_as = Phase::wait);
  /// Rows of a message; fails the run where it belongs to another window.
  long rows_of(std::vector<double> const& buffer, long window, int tag, int source) const;

 private:
  Session::Impl& session_;
  std::vector<MPI_Request> requests_;
};

}  // namespace slidewave
