// The row of the particle side on its way to the writer: first rank to first rank, one a window.
#pragma once

#include "channel.hpp"
#include "sums.hpp"

namespace slidewave {

class Relay {
 public:
  explicit Relay(Session::Impl& session) : session_(session), channel_(session) {}
  void send(long window, DemSums sums, std::vector<Quantity> const& columns);
  void receive(long window, DemSums& sums, std::vector<Quantity>& columns);
  /// Until the last row has been taken.
  void finish() { channel_.finish("the last row"); }

 private:
  Session::Impl& session_;
  Channel channel_;
  std::vector<double> buffer_;
  std::string names_;
  bool named_ = false;
};

}  // namespace slidewave
