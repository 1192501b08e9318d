// Accuracy in the step, measured, and scenes at the edge: stiffness over nine decades with the step
// that the pre-flight check proposes, unequal sizes and densities, 100 m/s, a corner, nothing at
// all, and particles that vanish. Either right or refused, never not a number.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "pair_style.h"
#include "slidewave/physics/limits/contact_step.hpp"
#include "slidewave/physics/limits/overlap.hpp"
#include "small_scene.h"

namespace {

double const pi = std::acos(-1.0);

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.17g", value);
  return buffer;
}

// Slope of log(error) over log(step).
double order(std::vector<double> const& steps, std::vector<double> const& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  auto const n = static_cast<double>(steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    double const x = std::log(steps[k]);
    double const y = std::log(errors[k]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// A sphere that swings on the floor's spring and never leaves it: position after 2.3 rad.
double swing_error(double steps_per_radian) {
  SmallScene scene;
  scene.box("f f f");
  scene.law("model linear kn 1e7");
  scene.wall("floor", "model linear kn 1e7", "primitive type 1 zplane 0");
  scene.sphere(5, 5, 0.0999, 0.2);
  double const omega = std::sqrt(1e7 / scene.mass(1));
  double const start = scene.x(1, 2) - 0.1;
  long const steps = std::lround(1.4 * steps_per_radian);
  scene.lines({"fix integrate all nve/sphere", "timestep " + text(1.4 / omega / steps),
               "run " + std::to_string(steps)});
  return std::abs(scene.x(1, 2) - 0.1 - start * std::cos(1.4));
}

// Two spheres meet at 2 m/s; mean square error of the exit speed over eight ways for the first
// touch to fall between two steps.
double collision_error(std::string const& law, double exit_speed, double steps) {
  double sum = 0;
  for (int phase = 0; phase < 8; ++phase) {
    SmallScene scene;
    scene.box("f f f");
    scene.law("model linear kn 1e6 " + law);
    double const omega = std::sqrt(2 * 1e6 / (2650 * pi / 6 * 0.008));
    double const dt_s = pi / omega / steps;
    double const gap_m = 2 * dt_s * (1 + phase / 8.0);
    scene.sphere(4.9 - gap_m / 2, 5, 5, 0.2);
    scene.sphere(5.1 + gap_m / 2, 5, 5, 0.2);
    scene.set_velocity(1, "1 0 0");
    scene.set_velocity(2, "-1 0 0");
    scene.lines({"fix integrate all nve/sphere", "timestep " + text(dt_s),
                 "run " + std::to_string(static_cast<int>(2 * steps) + 4)});
    double const error = (scene.v(2, 0) - scene.v(1, 0)) / 2 - exit_speed;
    sum += error * error / 8;
  }
  return std::sqrt(sum);
}

TEST(Accuracy, OrderInTheStep) {
  std::vector<double> const steps = {20, 40, 80, 160};
  std::vector<double> h, swing, elastic, damped;
  double const zeta = 0.2;
  double const e = std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
  for (double const n : steps) {
    h.push_back(1 / n);
    swing.push_back(swing_error(n));
    elastic.push_back(collision_error("", 1, n));
    damped.push_back(collision_error("attraction on damping " + text(zeta), e, n));
  }
  double const orders[3] = {order(h, swing), order(h, elastic), order(h, damped)};
  std::printf("orders: in contact %.2f, elastic collision %.2f, damped collision %.2f\n", orders[0],
              orders[1], orders[2]);
  EXPECT_NEAR(orders[0], 2, 0.15) << "velocity Verlet";
  EXPECT_GT(orders[1], 1.5) << "the force has a kink where contacts begin and end";
  EXPECT_GT(orders[2], 0.8) << "the dashpot sees the velocity half a step old";
}

TEST(Extremes, StiffnessOverNineDecadesAtTheProposedStep) {
  for (double kn = 1e3; kn < 2e12; kn *= 10) {
    SmallScene scene;
    scene.box("f f f");
    scene.law("model linear kn " + text(kn) + " tangential coulomb ks " + text(0.9 * kn) +
              " mu 0.5");
    scene.sphere(4.899, 5, 5, 0.2);
    scene.sphere(5.101, 5, 5, 0.2);
    double const depth = std::sqrt(scene.mass(1) / (2 * kn));  // at 2 m/s together: twice this
    double const speed = std::min(1.0, 0.01 / depth);          // at most 10 % of D
    scene.set_velocity(1, text(speed) + " 0 0");
    scene.set_velocity(2, text(-speed) + " 0 0");
    double const dt_s = slidewave::limits::comfortable_step_fraction *
                        slidewave::limits::critical_contact_step(scene.mass(1), kn, 0.9 * kn);
    long const steps = 40 + std::lround(0.002 / speed / dt_s);
    scene.lines(
        {"fix integrate all nve/sphere", "timestep " + text(dt_s), "run " + std::to_string(steps)});
    EXPECT_NEAR(scene.v(2, 0) / speed, 1, 0.1) << kn;
    EXPECT_EQ(scene.v(2, 1), 0) << kn;
  }
}

// Elastic impact of unequal spheres: v1' = (m1 - m2)/(m1 + m2) v, v2' = 2 m1/(m1 + m2) v.
void unequal(double diameter_m, double density, double speed_m_s, double kn) {
  SmallScene scene;
  scene.box("f f f");
  scene.law("model linear kn " + text(kn));
  double const second = 0.5;
  scene.sphere(5 - second / 2 - diameter_m / 2 - 0.001, 5, 5, diameter_m);
  scene.sphere(5, 5, 5, second);
  scene.lines(
      {"group first id 1", "set group first density " + text(density), "group first delete"});
  scene.set_velocity(1, text(speed_m_s) + " 0 0");
  double const m1 = scene.mass(1);
  double const m2 = scene.mass(2);
  double const reduced = m1 * m2 / (m1 + m2);
  double const dt_s = std::sqrt(reduced / kn) / 100;
  long const steps = std::lround((0.001 / speed_m_s + 2 * pi * std::sqrt(reduced / kn)) / dt_s);
  scene.lines(
      {"fix integrate all nve/sphere", "timestep " + text(dt_s), "run " + std::to_string(steps)});
  EXPECT_NEAR(scene.v(1, 0), (m1 - m2) / (m1 + m2) * speed_m_s, 1e-3 * speed_m_s);
  EXPECT_NEAR(scene.v(2, 0), 2 * m1 / (m1 + m2) * speed_m_s, 2e-3 * speed_m_s);
}

TEST(Extremes, SizesOneToTen) {
  unequal(0.05, 2650, 1, 1e7);
}
TEST(Extremes, DensitiesOneToThousand) {
  unequal(0.5, 2.65, 1, 1e7);
}
TEST(Extremes, HundredMetresASecond) {
  unequal(0.5, 2650, 100, 1e9);
}

TEST(Extremes, CornerOfThreeWallsGivesBackTheSpeed) {
  SmallScene scene;
  scene.box("f f f");
  scene.law("model linear kn 1e7");
  for (std::string const plane : {"xplane", "yplane", "zplane"}) {
    scene.wall("wall_" + plane, "model linear kn 1e7", "primitive type 1 " + plane + " 0");
  }
  scene.sphere(0.11, 0.12, 0.13, 0.2);
  scene.set_velocity(1, "-1 -2 -3");
  scene.lines({"fix integrate all nve/sphere", "timestep 1e-5", "run 5000"});
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(scene.v(1, axis), axis + 1, 1e-3) << axis;
  }
}

// Fifty spheres of 10 m on top of each other, stiff enough for 5 % at the foot as `check` proposes,
// brought to rest by drag: each contact carries the weight above it. What is left of the slowest
// mode, critically damped over 20/omega, is 21 exp(-20) of its 12 m: below the tolerance.
TEST(Extremes, ColumnOfFiveHundredMetresCarriesItsWeight) {
  int const count = 50;
  double const diameter_m = 10, g_m_s2 = 9.81, density = 2650, bulk = pi / 6 * density;
  double const kn = slidewave::limits::stiffness_for_static(
      slidewave::limits::static_overlap(count * diameter_m, bulk, g_m_s2, diameter_m, 1), 0.05, 1);
  SmallScene scene;
  scene.lines({"units si", "atom_style granular", "atom_modify map array sort 0 0",
               "boundary f f f", "newton off", "communicate single vel yes", "processors 1 1 *",
               "region box block 0 20 0 20 0 510 units box", "create_box 1 box", "neighbor 0.5 bin",
               "neigh_modify delay 0"});
  scene.law("model linear kn " + text(kn));
  scene.wall("floor", "model linear kn " + text(kn), "primitive type 1 zplane 0");
  for (int k = 0; k < count; ++k) {
    scene.sphere(10, 10, 10 * k + 5, diameter_m);
  }
  double const mass = scene.mass(1), slowest = pi / (2 * count + 1) * std::sqrt(kn / mass);
  double const dt_s = 0.1 * std::sqrt(mass / kn);
  scene.lines({"fix integrate all nve/sphere", "fix weight all gravity 9.81 vector 0 0 -1",
               "fix drag all viscous " + text(2 * mass * slowest), "timestep " + text(dt_s),
               "run " + std::to_string(std::lround(20 / slowest / dt_s))});
  double z = 0;
  for (int k = 0; k < count; ++k) {
    double const overlap_m = (count - k) * mass * g_m_s2 / kn;
    z += (k == 0 ? diameter_m / 2 : diameter_m) - overlap_m;
    EXPECT_NEAR(scene.x(k + 1, 2), z, 1e-6 * diameter_m) << k;
    EXPECT_EQ(scene.x(k + 1, 0), 10);
  }
  EXPECT_NEAR(mass * g_m_s2 * count / kn / diameter_m, 0.05, 1e-12);
}

TEST(Extremes, NoParticleAtAll) {
  SmallScene scene;
  scene.box("f p f");
  std::string const law = "model linear kn 1e7 tangential coulomb ks 8e6 mu 0.5";
  scene.law(law);
  scene.wall("floor", law, "primitive type 1 zplane 0");
  scene.lines({"fix integrate all nve/sphere", "timestep 1e-4", "run 20"});
  EXPECT_EQ(slidewave::dem::OwnPairs::current()->elastic().normal, 0);
}

// Particles deleted between two runs: the springs of those that stay are kept, whatever becomes of
// the order of the atoms; in the end all are gone.
TEST(Extremes, ParticlesVanish) {
  SmallScene scene;
  scene.box("f f f");
  scene.law("model linear kn 1e7 tangential coulomb ks 8e6 mu 0.5");
  for (int pair = 0; pair < 3; ++pair) {
    scene.sphere(2 + pair, 5, 5, 0.2);
    scene.sphere(2 + pair, 5, 5.195, 0.2);
    scene.set_velocity(2 * pair + 1, text(0.01 * (pair + 1)) + " 0 0");
  }
  scene.lines({"fix integrate all nve/sphere", "timestep 1e-6", "run 50"});
  auto const tangential = [] {
    double sum = slidewave::dem::OwnPairs::current()->elastic().tangential;
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum;
  };
  double const all_J = tangential();
  scene.lines(
      {"group gone id 1 2", "delete_atoms group gone compress no", "group gone delete", "run 0"});
  // Slips go as 1, 2, 3, their energies as 1, 4, 9.
  EXPECT_NEAR(tangential(), 13.0 / 14 * all_J, 1e-6 * all_J);
  scene.lines({"delete_atoms group all compress no", "run 20"});
  EXPECT_EQ(tangential(), 0);
}

}  // namespace
