// summary.json: what the run itself knows (keys of DESIGN.md 9). `slidewave report` adds targets
// and the times that lie outside the run.
#pragma once

#include <map>

#include "handshake.hpp"
#include "sums.hpp"

namespace slidewave {

class Summary {
 public:
  Summary(Session::Impl& session, Agreed const& agreed);
  void cells(double count) { cells_ = count; }
  /// Wall time [s] before the checkpoint that the run goes on from, and how often it has gone on.
  void goes_on(double wall_before_s, long restarts) {
    wall_before_s_ = wall_before_s;
    restarts_ = restarts;
  }
  void pass(State& state);
  void add(Window const& window, std::vector<Quantity> const& columns, DemSums const& dem,
           FluidSums const& fluid);
  void write(std::string const& status) const;

 private:
  Session::Impl& session_;
  Agreed const& agreed_;
  long windows_ = 0;
  double cells_ = 0;
  double wall_before_s_ = 0;
  long restarts_ = 0;
  DemSums dem_;
  FluidSums fluid_;
  std::vector<Quantity> last_;
  std::map<std::string, double> extremes_;
  std::map<std::string, double> budgets_;
};

/// The unit that a column's name ends in, e.g. "m/s" for slide_speed_m_s; "-" where it has none.
std::string unit_of(std::string const& column);

}  // namespace slidewave
