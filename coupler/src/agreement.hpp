// Small sums over the ranks of one side or of both, and text from a root: all with a deadline.
#pragma once

#include <string>
#include <vector>

#include "world.hpp"

namespace slidewave {

class Agreement {
 public:
  Agreement(World const& world, Waiter& waiter, Role role)
      : world_(world), waiter_(waiter), role_(role) {}

  /// In place, over all ranks of both sides (of the own side where there is no partner).
  void sum_all(double* values, int count, char const* what) const;
  void sum_side(double* values, int count, char const* what) const;
  void max_side(double* values, int count, char const* what) const;
  /// The first rank's text, on every rank of the side.
  void share_on_side(std::string& text, char const* what) const;
  void share_on_side(std::vector<double>& values, char const* what) const;
  /// First rank to first rank of the other side; both call it, each gets the other's text.
  std::string swap_between_roots(std::string const& text, char const* what) const;
  /// The halves of it, for text that goes one way.
  void send_text(std::string const& text, char const* what) const;
  std::string receive_text(char const* what) const;
  /// All boxes (or other fixed-size facts) of a side, on its first rank only.
  std::vector<double> gather_on_side(std::vector<double> const& mine, char const* what) const;

 private:
  void finish(MPI_Request& request, char const* what) const;

  World const& world_;
  Waiter& waiter_;
  Role role_;
};

}  // namespace slidewave
