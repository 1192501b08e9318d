// What an engine must supply to take part in a run: small, so that swapping engines is real.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "slidewave/state.hpp"
#include "slidewave/table.hpp"

namespace slidewave {

/// The time between two exchanges [s]. Window 0 has zero length: it only sets the initial state.
struct Window {
  long index = 0;
  double t0_s = 0;
  double t1_s = 0;
  bool stop = false;        ///< leave the loop, nothing is to be advanced
  bool checkpoint = false;  ///< write a restart state at the end of this window
  double length_s() const { return t1_s - t0_s; }
};

/// An axis-aligned box [m].
struct Box {
  Vec3 low = Vec3::Constant(1e300);
  Vec3 high = Vec3::Constant(-1e300);
};

/// Where a point lies in this rank's part of the mesh: distance 0 inside `cell`, else `cell` is the
/// nearest one and `distance_m` > 0 how far away it is. cell < 0: this rank has none.
struct Home {
  int cell = -1;
  double distance_m = 0;
};

/// A column of history.csv that an engine contributes, one value a window, same on all its ranks.
struct Quantity {
  std::string name;  ///< with its unit as suffix, e.g. "wave_height_m"
  double value = 0;
};

/// Something that a summary lists: a feature in use, or left out, and why.
struct Feature {
  std::string name;
  bool active = true;
  std::string reason;
};

class Engine {
 public:
  virtual ~Engine() = default;
  virtual Box bounds() const = 0;
  /// Own history columns after the last advance; always the same names in the same order.
  virtual std::vector<Quantity> quantities() const { return {}; }
  virtual std::vector<Feature> features() const { return {}; }
  /// Whether pass() gives everything of the engine that lives across windows; without it a run has
  /// no checkpoints.
  virtual bool passes_state() const { return false; }
  /// At the end of a window into a checkpoint, or out of one before the first window of a run that
  /// goes on. All ranks together.
  virtual void pass(State& /*state*/) {}
};

/// A field of FluidEngine::samples() and the column that takes its values at the particles.
struct Sample {
  std::string const& field;
  Table::Column out;
};

/// Something to be done with rows [begin, begin + count) of the particles.
using RowWork = std::function<void(long begin, long count)>;

/// A fluid: continuum on a mesh. Calls come in the order below, once a window. All MPI of the
/// engine stays on its own communicator; every rank gets every call, with zero particles too.
class FluidEngine : public Engine {
 public:
  /// Which fields sample() can give, among: velocity, mean_velocity [m/s], density [kg/m3],
  /// viscosity [Pa s], void_fraction, saturation [-], pressure_gradient [Pa/m] (with hydrostatics;
  /// time mean over the last advance, so that particles receive the impulse that the fluid gave),
  /// drag_reaction [Pa/m] (time mean of the force density of exchange() over the void fraction),
  /// acceleration [m/s2] (Du/Dt, time mean over the last advance of what add_mass() resisted),
  /// viscous_stress [Pa/m] (div tau, time mean over the last advance), vorticity [1/s] (curl u).
  virtual std::vector<Field> samples() const = 0;
  virtual Home locate(Vec3 const& position_m, int hint_cell) = 0;
  /// Position and cell of this rank's particles, and thus the kernel of deposit and sample until
  /// the next place(); the column stays as it is until then. Rows come sorted by cell.
  virtual void place(Table::ConstColumn position_m, std::vector<int> const& cell) = 0;
  /// Solid volume [m3] per particle, to stay until advance(): the void fraction ramps over the
  /// window from where it ended to this deposit. Not called without a model that needs porosity.
  virtual void deposit(Table::ConstColumn volume_m3) = 0;
  /// Drag of the coming window, per particle: K [kg/s], velocity [m/s], and a constant extra force
  /// on the fluid [N] (the ledger being repaid). The engine spreads them with weights proportional
  /// to density x void fraction at window start and solves K implicitly. Not called one-way.
  /// K may be negative where a grain pulls the fluid along (stiff regime), never the whole matrix.
  virtual void exchange(Table::ConstColumn drag_kg_s, Table::ConstColumn velocity_m_s,
                        Table::ConstColumn force_N) = 0;
  /// sample_all(), then evaluate() for all rows, which fills the columns of exchange() and of
  /// add_mass() from the samples, then exchange(): what a two-way run calls. Engines to which
  /// sampling and exchange are cheaper together override it and go through some rows at a time.
  /// evaluate() takes the rows in ascending order, each once.
  virtual void sample_and_exchange(std::vector<Sample> const& samples, RowWork const& evaluate,
                                   Table::ConstColumn const& drag_kg_s,
                                   Table::ConstColumn const& velocity_m_s,
                                   Table::ConstColumn const& force_N) {
    sample_all(samples);
    evaluate(0, drag_kg_s.cols());
    exchange(drag_kg_s, velocity_m_s, force_N);
  }
  /// Before exchange(), with virtual mass only: mass [kg] of fluid that each particle moves along,
  /// read in exchange(). Spread likewise, it adds (mass) Du/Dt to the fluid's momentum equation and
  /// to given_impulse(). For engines that offer acceleration.
  virtual void add_mass(Table::ConstColumn const& /*added_mass_kg*/) {}
  virtual void advance(Window const& window) = 0;
  /// Values at the particles by the exact transpose of deposit and smoothing, of the last advance;
  /// concurrently also asked for before the next. velocity, mean_velocity (time mean of each fluid
  /// step's final velocity) and acceleration, vorticity are weighted by density x void fraction at
  /// window start.
  virtual void sample(std::string const& field, Table::Column out) = 0;
  /// Several fields at one time: for engines to which that is cheaper than one by one.
  virtual void sample_all(std::vector<Sample> const& samples) {
    for (Sample const& one : samples) {
      sample(one.field, one.out);
    }
  }

  /// Momentum [kg m/s] that left the fluid through exchange() during the last advance, this rank's
  /// share, integrated from the source as it stood in the solved momentum equation.
  virtual Vec3 given_impulse() const = 0;
  /// Integral over this rank's cells of the stored solid fraction [m3], and of solid fraction times
  /// pressure gradient [N], for budgets that must be able to fail.
  virtual double solid_volume_m3() const = 0;
  virtual Vec3 solid_pressure_force() const = 0;
  /// The same of solid fraction times drag_reaction [N]; for engines that offer that field.
  virtual Vec3 solid_reaction_force() const { return Vec3::Zero(); }
};

/// Particles. gather -> (exchange: offer) -> apply -> advance, once a window. `memory` is what the
/// coupler wants kept with each particle wherever it migrates (opaque, zero at first; as many
/// components as the tables' column has, the same in a run).
class ParticleEngine : public Engine {
 public:
  /// Once, before pass() and the first gather(): which columns gather() will be asked for and
  /// apply() be given. The tables have no rows yet.
  virtual void expect(Table const& /*particles*/, Table const& /*answers*/) {}
  /// Fills position [m], velocity [m/s], radius [m], mass [kg], impulse [kg m/s] (drag impulse
  /// received since the last apply) and memory of this rank's particles, as far as the table has
  /// the column. Columns may be lent (Table::lend): they are read until the next apply().
  virtual void gather(Table& particles) = 0;
  /// Columns that gather() can fill beyond those, for scenes that need them (the stiff regime):
  /// travel [m] since the last apply, other_force [N] (all but the fluid's, now), stiffest [N/m]
  /// (physics/contact_secant.hpp). For coarse graining by type: type, a whole number from 1; such
  /// an engine states the fact particle_types, how many there are.
  virtual std::vector<std::string> extras() const { return {}; }
  /// Before the answers come, with the rows of the last gather: an engine may lend columns of its
  /// own for them, so that apply() finds them in place. `memory` may be the one lent to gather().
  virtual void offer(Table& /*answers*/) {}
  /// Same rows as the last gather: drag [kg/s], fluid_velocity [m/s], force [N] to act during the
  /// coming advance through the exponential kick (physics/exponential_kick.hpp), and memory; only
  /// columns that an enabled model fills are there (and those of takes()).
  virtual void apply(Table const& answers) = 0;
  /// Columns that apply() can take beyond those, for scenes that need them:
  /// added_mass [kg], inertia beside the particle's own; exchanged_force [N], acts like force, but
  /// belongs to impulse, as does -added_mass dv/dt: impulse = m dv - (force and all others) dt;
  /// rotational_drag R [N m s] and fluid_spin s [rad/s], torque R (s - w) through the same kick.
  virtual std::vector<std::string> takes() const { return {}; }
  virtual void advance(Window const& window) = 0;
  /// Drag impulse [kg m/s] that this rank's particles received since the last apply, summed over
  /// sub-steps as they went, independently of the impulse column: lets the momentum budget see an
  /// impulse that was lost with a sub-step or a migrating particle. Without it, the column is used.
  virtual std::optional<Vec3> received_impulse() const { return std::nullopt; }
};

}  // namespace slidewave
