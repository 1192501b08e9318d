// The coupling fix around LAMMPS' own integrator, window by window as the engine drives it, against
// closed forms. Every window is a LAMMPS run of its own, so a kick lost or doubled at a seam shows.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "atom.h"
#include "fix_slidewave.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "registry.h"

namespace {

using LAMMPS_NS::FixSlidewave;
using Vector = std::array<double, 3>;

// A box of side 10 m with spheres of 0.1 m diameter at (4 + 2 i, 5, 5), under gravity.
class Scene {
 public:
  explicit Scene(std::string const& boundary = "f f f", int spheres = 1) {
    std::string words[] = {"test", "-screen", "none", "-log", "none", "-nocite"};
    std::vector<char*> arguments;
    for (std::string& word : words) {
      arguments.push_back(word.data());
    }
    lmp_ = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()), arguments.data(),
                                               MPI_COMM_WORLD);
    slidewave::lammps::register_styles(*lmp_);
    lines({"units si", "atom_style sphere", "atom_modify map array", "boundary " + boundary,
           "newton off", "comm_modify vel yes cutoff 1", "processors * 1 1",
           "region box block 0 10 0 10 0 10 units box", "create_box 1 box", "neighbor 0.1 bin",
           "neigh_modify delay 0"});
    for (int i = 0; i < spheres; ++i) {
      lines({"create_atoms 1 single " + std::to_string(4 + 2 * i) + " 5 5 units box"});
    }
    lines({"set group all diameter 0.1 density 2650", "fix weight all gravity 9.81 vector 0 0 -1"});
  }

  void lines(std::vector<std::string> const& commands) {
    for (std::string const& command : commands) {
      lmp_->input->one(command);
    }
  }
  void add_kick(std::string const& columns) {
    lines({"fix kick all slidewave " + columns});
    kick_ = dynamic_cast<FixSlidewave*>(lmp_->modify->fix[lmp_->modify->find_fix("kick")]);
    ASSERT_TRUE(kick_);
  }
  /// A window: new answers for all particles, then `steps` steps.
  void window(double drag, Vector const& fluid, Vector const& force, int steps) {
    for (int i = 0; i < lmp_->atom->nlocal; ++i) {
      *kick_->values(FixSlidewave::drag, i) = drag;
      std::copy(fluid.begin(), fluid.end(), kick_->values(FixSlidewave::fluid_velocity, i));
      if (kick_->has(FixSlidewave::force_N)) {
        std::copy(force.begin(), force.end(), kick_->values(FixSlidewave::force_N, i));
      }
    }
    kick_->begin_window(running_);
    lines({"run " + std::to_string(steps) + (running_ ? " pre no" : "") + " post no"});
    running_ = true;
  }

  /// What `value(local index)` gives for atom `id`, on all ranks.
  template <class Value>
  double of_atom(int id, Value const& value) {
    double sums[2] = {0, 0};
    for (int i = 0; i < lmp_->atom->nlocal; ++i) {
      if (lmp_->atom->tag[i] == id) {
        sums[0] = value(i);
        sums[1] = 1;
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sums[1] == 1 ? sums[0] : std::nan("");
  }
  double x(int id, int axis) {
    return of_atom(id, [&](int i) { return lmp_->atom->x[i][axis]; });
  }
  double v(int id, int axis) {
    return of_atom(id, [&](int i) { return lmp_->atom->v[i][axis]; });
  }
  double impulse(int id, int axis) {
    return of_atom(id, [&](int i) { return kick_->values(FixSlidewave::impulse, i)[axis]; });
  }
  double received(int axis) {
    double sum = kick_->received()[static_cast<std::size_t>(axis)];
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum;
  }
  double mass_kg() {
    return of_atom(1, [&](int i) { return lmp_->atom->rmass[i]; });
  }
  FixSlidewave& kick() { return *kick_; }
  LAMMPS_NS::Atom& atoms() { return *lmp_->atom; }

 private:
  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp_;
  FixSlidewave* kick_ = nullptr;
  bool running_ = false;
};

// Constant forces: the composition of exact half kicks is the exact solution, whatever the step,
// and whatever another drag each window does.
TEST(Kick, FollowsTheExponentialAtAnyStiffnessAcrossWindows) {
  for (double const stiffness : {1e-3, 1e-1, 1.0, 10.0, 1e4}) {
    Scene fall;
    double const dt_s = 1e-3, mass = fall.mass_kg();
    int const steps = 5;
    fall.lines({"fix integrate all nve/sphere", "timestep 1e-3",
                "velocity all set 0.4 0.5 -0.6 units box"});
    fall.add_kick("drag fluid_velocity force impulse memory");
    Vector const u = {0.3, -0.2, 0.1}, extra = {2.5, 0, 1.5};
    Vector expected = {0.4, 0.5, -0.6};
    for (double const factor : {1.0, 0.5, 3.0, 1.0}) {
      double const drag = factor * stiffness * mass / dt_s;
      fall.window(drag, u, extra, steps);
      for (int axis = 0; axis < 3; ++axis) {
        auto const k = static_cast<std::size_t>(axis);
        double const force = extra[k] - (axis == 2 ? 9.81 * mass : 0);
        double const v_inf = u[k] + force / drag, before = expected[k];
        expected[k] = v_inf + (before - v_inf) * std::exp(-drag * dt_s * steps / mass);
        EXPECT_NEAR(fall.v(1, axis), expected[k], 1e-12 * (1 + std::abs(v_inf)))
            << "K dt/m " << stiffness << " axis " << axis;
        double const drag_impulse = mass * (expected[k] - before) - force * dt_s * steps;
        double const bound = 1e-11 * (std::abs(drag_impulse) + mass);
        EXPECT_NEAR(fall.impulse(1, axis), drag_impulse, bound) << stiffness << " axis " << axis;
        EXPECT_NEAR(fall.received(axis), drag_impulse, bound) << stiffness << " axis " << axis;
      }
    }
  }
}

TEST(Kick, ColumnsFollowTheParticleAcrossRanksAndThePeriodicFace) {
  Scene fall("p f f");
  double const dt_s = 1e-2, drag = 0.5 * fall.mass_kg() / dt_s;
  fall.lines({"fix integrate all nve/sphere", "timestep 1e-2"});
  fall.add_kick("drag fluid_velocity force impulse memory");
  for (int i = 0; i < fall.atoms().nlocal; ++i) {
    double const memory[4] = {1.5, -2.5, 3.5, 7};
    std::copy(memory, memory + 4, fall.kick().values(FixSlidewave::memory_column, i));
  }
  double const memory_kept[4] = {1.5, -2.5, 3.5, 7};
  double taken = 0;
  for (int const steps : {130, 570}) {  // ends in the upper half of the box, then in the lower
    fall.window(drag, {3, 0, 0}, {drag, 0, 9.81 * fall.mass_kg()}, steps);
    taken += fall.impulse(1, 0);
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(
          fall.of_atom(
              1, [&](int i) { return fall.kick().values(FixSlidewave::memory_column, i)[k]; }),
          memory_kept[k])
          << "component " << k << " at x = " << fall.x(1, 0);
    }
  }
  double const v_inf = 4;  // travels 28 m: three times through the box
  EXPECT_NEAR(fall.v(1, 0), v_inf, 1e-10);
  EXPECT_NEAR(fall.v(1, 2), 0, 1e-12);
  EXPECT_NEAR(taken, fall.mass_kg() * v_inf - drag * 7, 1e-9 * drag * 7);
}

// A sphere lying on a spring: contacts enter the kick, and the impulse is what momentum says.
TEST(Kick, ContactForcesArePartOfTheKick) {
  Scene fall;
  double const drag = 0.2 * fall.mass_kg() / 1e-4;  // over-damped: it comes to rest
  fall.lines({"pair_style gran/hooke/history 1e6 1e6 0 0 0.5 1", "pair_coeff * *",
              "fix floor all wall/gran hooke/history 1e6 1e6 0 0 0.5 1 zplane 4.95 NULL",
              "fix integrate all nve/sphere", "timestep 1e-4"});
  fall.add_kick("drag fluid_velocity impulse");
  double taken = 0;
  for (int window = 0; window < 10; ++window) {
    fall.window(drag, {0, 0, 0}, {}, 500);
    taken += fall.impulse(1, 2);
  }
  EXPECT_NEAR(fall.v(1, 2), 0, 1e-10);
  EXPECT_NEAR(fall.x(1, 2), 5 - fall.mass_kg() * 9.81 / 1e6, 1e-12);
  double const sunk_m = 5 - fall.x(1, 2);
  EXPECT_NEAR(taken, drag * sunk_m, 2e-3 * drag * sunk_m) << "integral of -K v dt";
}

TEST(Kick, HeldParticlesStayAndBookWhatTheyTake) {
  for (std::string const hold : {"freeze", "setforce 0 0 0", "none"}) {
    Scene scene("f f f", 2);
    scene.lines({"group held id 1", "group free id 2",
                 hold == "none" ? "fix integrate free nve/sphere" : "fix integrate all nve/sphere",
                 "timestep 1e-3"});
    if (hold != "none") {
      scene.lines({"fix hold held " + hold});
    }
    scene.add_kick("drag fluid_velocity force impulse");
    Vector const u = {0.1, 0.2, -0.3};
    for (int window = 0; window < 2; ++window) {
      scene.window(7, u, {5, 5, 5}, 25);
    }
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(scene.x(1, axis), axis == 0 ? 4 : 5) << hold;
      EXPECT_EQ(scene.v(1, axis), 0) << hold;
      EXPECT_NE(scene.v(2, axis), 0) << hold;
      EXPECT_NEAR(scene.impulse(1, axis), 7 * u[static_cast<std::size_t>(axis)] * 0.025, 1e-13)
          << hold;
    }
  }
}

TEST(Kick, AFreeComponentBesideAHeldOneIsKicked) {
  Scene scene;
  scene.lines({"unfix weight", "fix integrate all nve/sphere", "fix slab all setforce NULL 0 NULL",
               "timestep 1e-3"});
  scene.add_kick("drag fluid_velocity impulse");
  scene.window(7, {0.1, 0.2, -0.3}, {}, 50);
  double const decay = std::exp(-7 * 0.05 / scene.mass_kg());
  EXPECT_NEAR(scene.v(1, 0), 0.1 * (1 - decay), 1e-14);
  EXPECT_EQ(scene.v(1, 1), 0);
  EXPECT_NEAR(scene.v(1, 2), -0.3 * (1 - decay), 1e-14);
}

}  // namespace
