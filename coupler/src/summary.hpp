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
  void add(Window const& window, std::vector<Quantity> const& columns, DemSums const& dem,
           FluidSums const& fluid);
  void write(std::string const& status) const;

 private:
  Session::Impl& session_;
  Agreed const& agreed_;
  long windows_ = 0;
  double cells_ = 0;
  DemSums dem_;
  FluidSums fluid_;
  std::vector<Quantity> last_;
  std::map<std::string, double> extremes_;
  std::map<std::string, double> budgets_;
};

/// The unit that a column's name ends in, e.g. "m/s" for slide_speed_m_s; "-" where it has none.
std::string unit_of(std::string const& column);

}  // namespace slidewave
