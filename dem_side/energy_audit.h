// Energy audit of a run with our own contact law: what there is, what was turned into heat, what
// came from outside. Columns of history.csv (left out where the scene cannot have them):
//
//   energy_translation_J energy_rotation_J               kinetic
//   energy_normal_J energy_tangential_J energy_rolling_J in the springs of contacts
//   energy_gravity_J                                     potential, 0 at the start
//   heat_friction_J heat_damping_J heat_rolling_J        lost since the start
//   work_fluid_J work_walls_J                            done on the particles since the start
//   energy_drift                                         what does not add up, over the turnover
//
// Turnover: the largest energy that moved or was stored so far, plus heat and work. All is booked
// step by step as the mean of the forces before and after a step times the displacement, which is
// what velocity Verlet does to the kinetic energy up to a bounded term of second order: a drift
// means that the particle step is too long for the contacts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "slidewave/engine.hpp"
#include "slidewave/state.hpp"

namespace LAMMPS_NS {
class FixFluidWork;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace slidewave::dem {

class EnergyAudit {
 public:
  /// Above this share of the turnover the drift is told; energy gained beyond the second ends the
  /// run.
  static constexpr double warning = 0.05;
  static constexpr double limit = 0.5;

  /// `with_fluid`: there is a fluid side, so that its work has a column from the first row on.
  EnergyAudit(LAMMPS_NS::LAMMPS& lmp, bool with_fluid) : lmp_(lmp), with_fluid_(with_fluid) {}

  /// Why the books cannot close here (a packaged law, a fix whose work nobody counts); empty: they
  /// do.
  static std::string obstacle(LAMMPS_NS::LAMMPS& lmp);

  /// Counts the fluid's work from now on. Call once fix slidewave stands, before the set-up.
  void add_fluid();
  /// Values now, same on all ranks; empty (NaN) before the forces of the start are known.
  /// Collective.
  std::vector<Quantity> observe();
  double drift() const { return drift_; }
  /// With the integrator set up: all that counts from the start. `rank` of this process.
  void pass(State& state, int rank);
  bool started() const { return started_; }

 private:
  struct Books {
    double particles = 0;
    double translation = 0;
    double rotation = 0;
    double normal = 0;
    double tangential = 0;
    double rolling = 0;
    double gravity = 0;
    double friction_heat = 0;
    double damping_heat = 0;
    double rolling_heat = 0;
    double fluid_work = 0;
    double wall_work = 0;

    double stored() const { return translation + rotation + normal + tangential + rolling; }
    double heat() const { return friction_heat + damping_heat + rolling_heat; }
    double work() const { return fluid_work + wall_work; }
  };
  Books add_up() const;
  void close(Books const& books);

  LAMMPS_NS::LAMMPS& lmp_;
  bool with_fluid_;
  LAMMPS_NS::FixFluidWork* fluid_ = nullptr;
  bool started_ = false;
  Books start_;
  double particles_ = 0;
  double start_J_ = 0;
  double most_J_ = 0;
  double drift_ = 0;
};

}  // namespace slidewave::dem
