// D1, D2, D7 of PHYSICS.md 3.1: normal law of pairs and walls, against closed forms. Contacts lie
// on the border of two ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "small_scene.h"

namespace {

double const pi = std::acos(-1.0);

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.17g", value);
  return buffer;
}

struct Impact {
  double exit_speed = 0;
  double largest_overlap_m = 0;
  double omega = 0;  // of the contact [rad/s]
};

// Two spheres of 0.2 m meet head-on at 2 m/s; `steps` per contact time of the undamped spring.
Impact collide(std::string const& law, double kn, double steps) {
  SmallScene scene;
  scene.box("f f f");
  scene.law("model linear kn " + text(kn) + " " + law);
  scene.sphere(4.899, 5, 5, 0.2);
  scene.sphere(5.101, 5, 5, 0.2);
  scene.set_velocity(1, "1 0 0");
  scene.set_velocity(2, "-1 0 0");
  Impact impact;
  impact.omega = std::sqrt(2 * kn / scene.mass(1));
  double const dt_s = pi / impact.omega / steps;
  scene.lines({"fix integrate all nve/sphere", "timestep " + text(dt_s)});
  int const before = static_cast<int>(0.001 / dt_s) + 1;
  scene.lines({"run " + std::to_string(before + static_cast<int>(steps / 2))});
  impact.largest_overlap_m = 0.2 - (scene.x(2, 0) - scene.x(1, 0));
  scene.lines({"run " + std::to_string(static_cast<int>(2 * steps))});
  EXPECT_GT(scene.x(2, 0) - scene.x(1, 0), 0.2) << "still in contact";
  impact.exit_speed = (scene.v(2, 0) - scene.v(1, 0)) / 2;
  return impact;
}

TEST(NormalLaw, ElasticCollisionSwapsSpeedsToSecondOrder) {
  for (double const steps : {50.0, 365.0, 1500.0}) {
    Impact const impact = collide("", 1e6, steps);
    double const energy_error = std::abs(impact.exit_speed * impact.exit_speed - 1);
    EXPECT_LT(energy_error, std::pow(pi / steps, 2)) << "(omega dt)^2, " << steps;
  }
  Impact const fine = collide("", 1e6, 1500);
  EXPECT_NEAR(fine.largest_overlap_m, 2 / fine.omega, 2e-3 * 2 / fine.omega);
}

TEST(NormalLaw, StiffnessOverNineDecades) {
  for (double const kn : {1e4, 1e8, 1e12}) {
    EXPECT_NEAR(collide("", kn, 400).exit_speed, 1, 1e-4) << kn;
  }
}

TEST(NormalLaw, RestitutionOfTheDashpot) {
  for (double const zeta : {0.05, 0.2, 0.6}) {
    double const root = std::sqrt(1 - zeta * zeta);
    Impact const pulls = collide("damping " + text(zeta) + " attraction on", 1e6, 2000);
    EXPECT_NEAR(pulls.exit_speed, std::exp(-pi * zeta / root), 3e-3) << zeta;
    // Without attraction the contact ends where the force does (Schwager & Poschel 2007).
    double const angle = std::atan2(2 * zeta * root, 1 - 2 * zeta * zeta);
    Impact const pushes = collide("damping " + text(zeta), 1e6, 2000);
    EXPECT_NEAR(pushes.exit_speed, std::exp(-zeta / root * (pi - angle)), 3e-3) << zeta;
  }
}

// Undamped bounces on a plane keep their height; damped ones lose 1 - e^2 each.
TEST(NormalLaw, BounceHeights) {
  for (double const zeta : {0.0, 0.1}) {
    SmallScene scene;
    scene.box("f f f");
    std::string const law = "model linear kn 1e7 damping " + text(zeta) + " attraction on";
    scene.law(law);
    scene.wall("floor", law, "primitive type 1 zplane 0");
    scene.sphere(5, 5, 1.1, 0.2);
    double const omega = std::sqrt(1e7 / scene.mass(1));
    double const e = std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
    scene.lines({"fix integrate all nve/sphere", "fix weight all gravity 9.81 vector 0 0 -1",
                 "timestep " + text(pi / omega / 200)});
    double const half_s = std::sqrt(2 / 9.81);
    scene.lines({"run " + std::to_string(static_cast<int>(half_s * (1 + e) * omega * 200 / pi))});
    EXPECT_NEAR(scene.x(1, 2) - 0.1, e * e, 5e-3) << "one bounce, zeta " << zeta;
    double const energy = 0.5 * scene.v(1, 2) * scene.v(1, 2) + 9.81 * (scene.x(1, 2) - 0.1);
    EXPECT_NEAR(energy, 9.81 * e * e, 4e-3 * 9.81);
  }
}

// Two spheres squeezed between two plates: both contacts carry what statics says.
TEST(NormalLaw, StackedPairCarriesItsWeight) {
  SmallScene scene;
  scene.box("f f f");
  scene.law("model linear kn 1e6 damping 0.3");
  scene.wall("floor", "model linear kn 2e6 damping 0.3", "primitive type 1 zplane 0");
  scene.sphere(5, 5, 0.1, 0.2);
  scene.sphere(5, 5, 0.3, 0.2);
  scene.lines({"fix integrate all nve/sphere", "fix weight all gravity 9.81 vector 0 0 -1",
               "timestep 2e-4", "run 5000"});
  double const weight_N = 9.81 * scene.mass(1);
  EXPECT_NEAR(0.1 - scene.x(1, 2), 2 * weight_N / 2e6, 1e-12);
  EXPECT_NEAR(0.2 - (scene.x(2, 2) - scene.x(1, 2)), weight_N / 1e6, 1e-12);
}

}  // namespace
