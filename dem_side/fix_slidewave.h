// fix ID all slidewave [drag K] [fluid_velocity ux uy uz] [force fx fy fz] [added_mass M]
//                      [exchanged_force ex ey ez] [rotational_drag R] [fluid_spin sx sy sz]
//                      [impulse] [memory [N]] [start]
//
// What the fluid does to particles, around any velocity-Verlet integrator. Before each half kick
// the force on an atom is replaced by the effective one that makes the integrator carry out the
// exact solution of (m + M) dv/dt = K (u - v) + E + (contacts + weight + F) with all of it frozen
// over dt/2 (physics/exponential_kick.hpp); K (u - v) + E - M dv/dt is summed up in `impulse`. Must
// stand last in the list of fixes, so that it sees the whole force.
//
// Likewise I dw/dt = R (s - w) + (torque of contacts), for spheres that nve/sphere turns; one that
// is held in all directions gets no torque from the fluid.
//
// Every name is a column of its own, kept with the atom wherever it goes and through restarts; what
// is not named is neither stored nor used. Units: K [kg/s], u [m/s], F, E [N], M [kg], impulse [kg
// m/s]; `memory` (N numbers, 4 unless told) belongs to the coupler; `start` [m] is where the atom
// stood at begin_window(), periodic images undone. The numbers given are the values of every atom
// at first; the engine overwrites them once a window.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "atom.h"
#include "fix.h"
#include "held_atoms.h"
#include "slidewave/physics/exponential_kick.hpp"

namespace LAMMPS_NS {

class FixPropertyAtom;

class FixSlidewave : public Fix {
 public:
  FixSlidewave(LAMMPS* lmp, int argument_count, char** arguments);
  void post_create() override;
  void pre_delete(bool unfixed) override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void pre_initial_integrate() override;
  void post_force(int) override;
  void reset_dt() override { factors_valid_ = false; }
  /// Sum of `impulse` over all atoms of all ranks, component `axis` [kg m/s].
  double compute_vector(int axis) override;

  bool has(std::string const& column) const { return columns_.count(column) > 0; }
  /// The column's values of a local atom: 1, 3 or 4 numbers. The column must exist.
  double* values(std::string const& column, int atom) const;
  /// Those of all local atoms, one after the other, until atoms migrate or are created.
  struct Values {
    double* first = nullptr;
    int components = 0;
    double* operator[](int atom) const { return first + static_cast<long>(components) * atom; }
  };
  Values values(std::string const& column) const;
  /// New values of drag: a window begins, the impulse is counted from zero.
  void begin_window();
  /// Drag impulse [kg m/s] of this rank's atoms since begin_window(), counted kick by kick and not
  /// read from the column, which may lose it with an atom.
  std::array<double, 3> const& received() const { return received_; }
  /// How far [m] a local atom has gone since begin_window(); needs `start`.
  std::array<double, 3> travel(int atom) const;
  /// True where no force moves the atom in any direction.
  bool held(int atom) const;
  /// Takes the other forces from atom->f.
  void keep_forces();

  /// Contacts, weight and other fixes [N], without the fluid's force, at the end of the last step
  /// or set-up: what the next half kick of a local atom begins with.
  double const* other_force_N(int i) const {
    return other_force_N_.data() + 3 * static_cast<std::size_t>(i);
  }
  /// The same of torques [N m]; only with rotational_drag.
  double const* other_torque_N_m(int i) const {
    return other_torque_N_m_.data() + 3 * static_cast<std::size_t>(i);
  }
  /// Moment of inertia of a local atom.
  double inertia_kg_m2(std::size_t i) const {
    return 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
  }

 private:
  struct Column {
    int components = 1;
    std::vector<double> initial;
    FixPropertyAtom* store = nullptr;
  };

  /// A column's values of all atoms; null where it was not named.
  double* numbers_of(std::string const& column) const;
  double** vectors_of(std::string const& column) const;
  /// What a kick reads and writes of the columns; null where one was not named.
  struct KickColumns {
    double const* drag;
    double* const* fluid;
    double const* added;
    double* const* extra;
    double* const* exchanged;
    double* const* impulse;
  };
  void update_factors();
  void kick();
  void kick_usual(KickColumns const& columns);
  void kick_any(int i, KickColumns const& columns, std::array<double, 3>& received);
  void turn();

  std::map<std::string, Column> columns_;
  slidewave::dem::HeldAtoms held_;
  std::vector<double> other_force_N_;  // contacts, weight, other fixes; 3 per local atom
  std::vector<double> other_torque_N_m_;
  std::vector<slidewave::KickFactors> factors_, turn_factors_;
  bool factors_valid_ = false;
  std::array<double, 3> received_{};
};

}  // namespace LAMMPS_NS
