// The coupling fix around LIGGGHTS' own integrator, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "fix_slidewave.h"
#include "modify.h"
#include "small_scene.h"

namespace {

std::string text(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

struct Falling {
  SmallScene scene;
  double mass_kg = 0;

  explicit Falling(std::string const& boundary = "f f f") {
    scene.box(boundary);
    scene.sphere(4, 5, 5, 0.1);
    mass_kg = scene.mass(1);
    scene.lines({"fix integrate all nve/sphere", "fix weight all gravity 9.81 vector 0 0 -1"});
  }
  void fluid(double drag, std::string const& velocity, std::string const& force) {
    scene.lines({"fix fluid all slidewave drag " + text(drag) + " fluid_velocity " + velocity +
                 " force " + force + " impulse"});
  }
  double impulse(int axis) {
    return scene.lmp().modify->find_fix_id("fluid")->compute_vector(axis);
  }
};

// Constant forces: the composition of exact half kicks is the exact solution, whatever the step.
TEST(Kick, FollowsTheExponentialAtAnyStiffness) {
  for (double const stiffness : {1e-3, 1e-1, 1.0, 10.0, 1e4}) {
    Falling fall;
    double const dt_s = 1e-3;
    int const steps = 20;
    double const drag = stiffness * fall.mass_kg / dt_s;
    fall.fluid(drag, "0.3 -0.2 0.1", "2.5 0 1.5");
    fall.scene.lines({"velocity all set 0.4 0.5 -0.6 units box", "timestep " + text(dt_s),
                      "run " + std::to_string(steps)});
    double const u[3] = {0.3, -0.2, 0.1};
    double const v0[3] = {0.4, 0.5, -0.6};
    double const force[3] = {2.5, 0, 1.5 - 9.81 * fall.mass_kg};
    for (int axis = 0; axis < 3; ++axis) {
      double const v_inf = u[axis] + force[axis] / drag;
      double const expected =
          v_inf + (v0[axis] - v_inf) * std::exp(-drag * dt_s * steps / fall.mass_kg);
      EXPECT_NEAR(fall.scene.v(1, axis), expected, 1e-12 * (1 + std::abs(v_inf)))
          << "K dt/m " << stiffness << " axis " << axis;
      double const received =
          fall.mass_kg * (fall.scene.v(1, axis) - v0[axis]) - force[axis] * dt_s * steps;
      EXPECT_NEAR(fall.impulse(axis), received, 1e-11 * (std::abs(received) + fall.mass_kg))
          << "K dt/m " << stiffness << " axis " << axis;
    }
  }
}

TEST(Kick, SettlesAtTheTerminalSlip) {
  for (double const stiffness : {1e-3, 1.0, 1e4}) {
    Falling fall("f f p");
    double const dt_s = 1e-3;
    double const drag = stiffness * fall.mass_kg / dt_s;
    fall.fluid(drag, "0 0 0.05", "0 0 0");
    double const slip = fall.mass_kg * 9.81 / drag;
    // Starts near the end, so that the soft case needs no 1e5 steps to forget its start.
    fall.scene.lines({"velocity all set 0 0 " + text(0.05 - 0.999 * slip) + " units box",
                      "timestep " + text(dt_s), "run " + text(stiffness < 1 ? 20000 : 200)});
    EXPECT_NEAR(fall.scene.v(1, 2) - 0.05, -slip, 1e-10 * slip + 1e-16) << "K dt/m " << stiffness;
  }
}

TEST(Kick, ColumnsFollowTheParticleAcrossRanksAndThePeriodicFace) {
  Falling fall("p f f");
  double const dt_s = 1e-2;
  double const drag = 0.5 * fall.mass_kg / dt_s;
  fall.fluid(drag, "3 0 0", text(drag) + " 0 " + text(9.81 * fall.mass_kg));
  fall.scene.lines({"timestep " + text(dt_s), "run 700"});
  double const v_inf = 4;  // travels 28 m: three times through the box
  EXPECT_NEAR(fall.scene.v(1, 0), v_inf, 1e-10);
  EXPECT_NEAR(fall.scene.v(1, 2), 0, 1e-12);
  EXPECT_NEAR(fall.impulse(0), fall.mass_kg * v_inf - drag * 7, 1e-9 * drag * 7);
}

// A sphere lying on a spring: contacts enter the kick, and the impulse is what momentum says.
TEST(Kick, ContactForcesArePartOfTheKick) {
  Falling fall;
  fall.scene.contacts(1e6, 1e6, 0.5);
  fall.scene.lines(
      {"fix floor all wall/gran model hooke/stiffness tangential history primitive "
       "type 1 zplane 4.95"});
  double const dt_s = 1e-4;
  double const drag = 0.2 * fall.mass_kg / dt_s;  // over-damped: it comes to rest
  fall.fluid(drag, "0 0 0", "0 0 0");
  fall.scene.lines({"timestep " + text(dt_s), "run 5000"});
  EXPECT_NEAR(fall.scene.v(1, 2), 0, 1e-10);
  EXPECT_NEAR(fall.scene.x(1, 2), 5 - fall.mass_kg * 9.81 / 1e6, 1e-12);
  double const sunk_m = 5 - fall.scene.x(1, 2);
  EXPECT_NEAR(fall.impulse(2), drag * sunk_m, 2e-3 * drag * sunk_m) << "integral of -K v dt";
}

TEST(Kick, HeldParticlesStayAndBookWhatTheyTake) {
  for (std::string const hold : {"freeze", "setforce 0 0 0", "none"}) {
    SmallScene scene;
    scene.box("f f f");
    scene.sphere(4, 5, 5, 0.1);
    scene.sphere(6, 5, 5, 0.1);
    scene.lines(
        {"group held id 1", "group free id 2",
         hold == "none" ? "fix integrate free nve/sphere" : "fix integrate all nve/sphere"});
    if (hold != "none") {
      scene.lines({"fix hold held " + hold});
    }
    scene.lines({"fix fluid all slidewave drag 7 fluid_velocity 0.1 0.2 -0.3 force 5 5 5 impulse",
                 "timestep 1e-3", "run 50"});
    double const u[3] = {0.1, 0.2, -0.3};
    auto* const fix =
        dynamic_cast<LAMMPS_NS::FixSlidewave*>(scene.lmp().modify->find_fix_id("fluid"));
    ASSERT_TRUE(fix);
    double const start_m[3] = {4, 5, 5};
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(scene.x(1, axis), start_m[axis]) << hold;
      EXPECT_EQ(scene.v(1, axis), 0) << hold;
      // (K u + F)/K (1 - exp(-K t/m)): the atom behind a held one takes its own columns.
      double const decay = std::exp(-7 * 0.05 / scene.mass(2));
      EXPECT_NEAR(scene.v(2, axis), (u[axis] + 5.0 / 7) * (1 - decay), 1e-13) << hold;
      double const taken = scene.of_atom(1, [&](int i) { return fix->values("impulse", i)[axis]; });
      EXPECT_NEAR(taken, 7 * u[axis] * 0.05, 1e-13) << hold;
    }
  }
}

TEST(Kick, AFreeComponentBesideAHeldOneIsKicked) {
  SmallScene scene;
  scene.box("f f f");
  scene.sphere(4, 5, 5, 0.1);
  scene.lines({"fix integrate all nve/sphere", "fix slab all setforce NULL 0 NULL",
               "fix fluid all slidewave drag 7 fluid_velocity 0.1 0.2 -0.3 impulse",
               "timestep 1e-3", "run 50"});
  double const decay = std::exp(-7 * 0.05 / scene.mass(1));
  EXPECT_NEAR(scene.v(1, 0), 0.1 * (1 - decay), 1e-14);
  EXPECT_EQ(scene.v(1, 1), 0);
  EXPECT_NEAR(scene.v(1, 2), -0.3 * (1 - decay), 1e-14);
}

// (m + M) dv/dt = K (u - v) + E + F + weight: exact in time, and the impulse is what the particle's
// own momentum says that the fluid handed over beside F.
TEST(Kick, AddedMassIsInertiaAndItsReactionIsBooked) {
  for (double const stiffness : {0.0, 1e-3, 1.0, 1e3}) {
    Falling fall;
    double const dt_s = 1e-3, added = 0.7 * fall.mass_kg, inertia = fall.mass_kg + added;
    double const drag = stiffness * fall.mass_kg / dt_s;
    int const steps = 20;
    fall.scene.lines({"fix fluid all slidewave drag " + text(drag) +
                      " fluid_velocity 0.3 -0.2 0.1 force 2.5 0 1.5 added_mass " + text(added) +
                      " exchanged_force 0.5 -4 0 impulse"});
    fall.scene.lines({"velocity all set 0.4 0.5 -0.6 units box", "timestep " + text(dt_s),
                      "run " + std::to_string(steps)});
    double const u[3] = {0.3, -0.2, 0.1}, v0[3] = {0.4, 0.5, -0.6}, exchanged[3] = {0.5, -4, 0};
    double const force[3] = {2.5, 0, 1.5 - 9.81 * fall.mass_kg};
    double const time_s = dt_s * steps;
    for (int axis = 0; axis < 3; ++axis) {
      double const all = force[axis] + exchanged[axis];
      double const v_inf = drag > 0 ? u[axis] + all / drag : 0;
      double const expected = drag > 0
                                  ? v_inf + (v0[axis] - v_inf) * std::exp(-drag * time_s / inertia)
                                  : v0[axis] + all * time_s / inertia;
      EXPECT_NEAR(fall.scene.v(1, axis), expected, 1e-12 * (1 + std::abs(v_inf))) << stiffness;
      double const received =
          fall.mass_kg * (fall.scene.v(1, axis) - v0[axis]) - force[axis] * time_s;
      EXPECT_NEAR(fall.impulse(axis), received, 1e-11 * (std::abs(received) + fall.mass_kg))
          << stiffness;
    }
  }
}

TEST(Kick, TurnsTowardsTheFluidsSpinAtAnyStiffness) {
  for (double const stiffness : {1e-3, 1.0, 1e3}) {
    Falling fall;
    double const dt_s = 1e-3, inertia = 0.4 * fall.mass_kg * 0.05 * 0.05;
    int const steps = 20;
    fall.scene.lines({"fix fluid all slidewave rotational_drag " +
                      text(stiffness * inertia / dt_s) + " fluid_spin 3 0 -2"});
    fall.scene.lines({"timestep " + text(dt_s), "run " + std::to_string(steps)});
    double const spin[3] = {3, 0, -2};
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(fall.scene.omega(1, axis), spin[axis] * (1 - std::exp(-stiffness * steps)), 1e-12)
          << stiffness;
    }
    EXPECT_NEAR(fall.scene.v(1, 2), -9.81 * dt_s * steps, 1e-12);
  }
}

}  // namespace
