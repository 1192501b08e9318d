// Messages whose receivers know neither how many come nor from whom (NBX, Hoefler et al. 2010):
// synchronous sends, then a non-blocking barrier. Only dem ranks send, only fluid ranks receive;
// the cost on a rank is its own messages and a barrier, whatever the number of ranks.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "world.hpp"

namespace slidewave {

/// The sending half. Buffers belong to the caller and stay untouched until finish().
class SparseSender {
 public:
  SparseSender(World const& world, Waiter& waiter) : world_(world), waiter_(waiter) {}
  void send(int fluid_rank, std::vector<double> const& buffer, int tag);
  /// Every dem rank calls it once a round, with nothing sent too.
  void finish(char const* what);

 private:
  World const& world_;
  Waiter& waiter_;
  std::vector<MPI_Request> requests_;
};

struct Incoming {
  int source = -1;
  std::vector<double> data;
};

/// The receiving half. Buffers are kept and used again.
class SparseReceiver {
 public:
  SparseReceiver(World const& world, Waiter& waiter) : world_(world), waiter_(waiter) {}
  /// All messages of a round, by rank of the sender: the order does not depend on arrival.
  /// They stay valid until the next call.
  std::vector<Incoming*> const& collect(int tag, char const* what);

 private:
  void take_arrived(int tag);

  World const& world_;
  Waiter& waiter_;
  std::deque<Incoming> pool_;
  std::vector<Incoming*> arrived_;
  std::vector<MPI_Request> requests_;
};

}  // namespace slidewave
