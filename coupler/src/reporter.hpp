// The one writer of a run: history.csv, summary.json and progress, on the first rank of the fluid
// side (of the particle side where it runs alone).
#pragma once

#include "budgets.hpp"
#include "checkpoints.hpp"
#include "handshake.hpp"
#include "history.hpp"
#include "progress.hpp"
#include "summary.hpp"

namespace slidewave {

class Reporter {
 public:
  /// Goes on with the files of the run where `checkpoints` has found one; pass() comes next.
  Reporter(Session::Impl& session, Agreed const& agreed, Windows const& windows,
           Checkpoints const& checkpoints);
  /// A finished window: sums over all ranks of both sides, and the engines' own columns.
  void add(Window const& window, DemSums const& dem, std::vector<Quantity> const& dem_columns,
           FluidSums const& fluid, std::vector<Quantity> const& fluid_columns);
  void finish(bool stopped);
  void pass(State& state);
  long history_bytes() { return history_.bytes(); }
  Spent spent() const;

 private:
  Session::Impl& session_;
  Budgets budgets_;
  History history_;
  Progress progress_;
  Summary summary_;
  double gravity_m_s2_;
  Spent before_;  ///< of the run that this one goes on
  DemSums dem_;
  FluidSums fluid_;
  double setup_wait_s_[2] = {-1, -1};  ///< fluid, dem: waits before the first window
};

}  // namespace slidewave
