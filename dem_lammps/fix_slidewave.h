// fix ID all slidewave [drag] [fluid_velocity] [force] [impulse] [memory]
//
// What the fluid does to particles, around LAMMPS' velocity-Verlet integrators. For each half kick
// the force on an atom is replaced by the effective one that makes the integrator carry out the
// exact solution of m dv/dt = K (u - v) + (contacts + weight + F) with all of it frozen over dt/2
// (physics/exponential_kick.hpp); the drag's share is summed up in `impulse`.
//
// LAMMPS calls nothing of a fix between the end of a step and the first half kick of the next one
// unless the fix stands before the integrator. So this one, which must stand last to see the whole
// force, sets the force of the second half kick in post_force and that of the next step's first in
// end_of_step; for the first step of a window, whose K is not known before, begin_window() does.
//
// Every name is a column, kept with the atom wherever it goes; what is not named is neither stored
// nor used. Units: K [kg/s], u [m/s], F [N], impulse [kg m/s]; `memory` (4 numbers) belongs to the
// coupler. Values are zero at first; the engine overwrites them once a window.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "fix.h"
#include "held_atoms.h"
#include "slidewave/physics/exponential_kick.hpp"

namespace LAMMPS_NS {

class FixSlidewave : public Fix {
 public:
  FixSlidewave(LAMMPS* lmp, int argument_count, char** arguments);
  ~FixSlidewave() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  void end_of_step() override;
  void reset_dt() override { factors_valid_ = false; }

  void grow_arrays(int atoms) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  double memory_usage() override;

  enum Column { drag, fluid_velocity, force_N, impulse, memory_column };
  static constexpr int columns = 5;
  /// Column of a name, -1 for none.
  static int column_of(std::string const& name);
  static int components(int column);

  bool has(int column) const { return start(column) >= 0; }
  /// The column's values of a local atom: 1, 3 or 4 numbers. The column must exist.
  double* values(int column, int atom_index) { return row(atom_index) + start(column); }
  /// New values of drag: a window begins, the impulse is counted from zero. `running`: forces of
  /// the last step's end are at hand, and the next run will not set up again.
  void begin_window(bool running);
  /// Drag impulse [kg m/s] of this rank's atoms since begin_window(), counted kick by kick and not
  /// read from the column, which may lose it with an atom.
  std::array<double, 3> const& received() const { return received_; }

 private:
  double* row(int atom_index) {
    return rows_.data() + static_cast<std::ptrdiff_t>(atom_index) * width_;
  }
  int start(int column) const { return starts_[static_cast<std::size_t>(column)]; }
  void keep_forces();
  void update_factors();
  void kick();

  std::array<int, columns> starts_;  // place of a column in an atom's row; -1: not stored
  int width_ = 0;
  std::vector<double> rows_;
  slidewave::lammps::HeldAtoms held_;
  std::vector<double> other_force_N_;  // contacts, weight, other fixes; 3 per local atom
  std::vector<slidewave::KickFactors> factors_;
  bool factors_valid_ = false;
  std::array<double, 3> received_{};
};

}  // namespace LAMMPS_NS
