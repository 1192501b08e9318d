// Budgets that can fail: what left the fluid's equations against what arrived at the particles.
#pragma once

#include <array>
#include <vector>

#include "models.hpp"
#include "slidewave/state.hpp"
#include "sums.hpp"

namespace slidewave {

class Budgets {
 public:
  /// `in_plane`: 0 along an axis that the fluid does not solve; budgets leave it out.
  Budgets(Models const& models, Vec3 const& in_plane) : models_(models), in_plane_(in_plane) {}
  void add(double window_s, double gravity_m_s2, DemSums const& dem, FluidSums const& fluid);
  void pass(State& state);
  /// The columns for history.csv, of the models in use.
  std::vector<Quantity> columns() const;

  /// sum over windows of |given - received - change of ledger|, over the sum of |J|.
  double momentum_defect() const;
  /// |ledger| over (sum |J| + sum m g W) of the last ten windows.
  double momentum_outstanding() const;
  /// | stored solid volume / volume of the particles - 1 |
  double solid_volume_defect() const { return solid_volume_defect_; }
  /// | sum V grad p at particles - integral of phi grad p | over the sum of |V grad p|
  double pressure_defect() const { return pressure_defect_; }
  double particles_lost() const { return first_.particles - last_.particles; }

 private:
  static constexpr int outstanding_windows = 10;
  Models models_;
  Vec3 in_plane_;
  bool started_ = false;
  DemSums first_;
  DemSums last_;
  FluidSums fluid_;
  Vec3 ledger_ = Vec3::Zero();
  double residual_ = 0;
  double received_abs_ = 0;
  std::array<double, outstanding_windows> turnover_{};
  long windows_ = 0;
  double solid_volume_defect_ = 0;
  double pressure_defect_ = 0;
  Vec3 constraint_ = Vec3::Zero();  ///< impulse taken by an axis that is not solved
};

}  // namespace slidewave
