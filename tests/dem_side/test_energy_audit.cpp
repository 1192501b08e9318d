// The energy audit against closed forms: what one impact, one stop or one push turns into heat or
// work, and that the books of a pile close, at any number of ranks.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "energy_audit.h"
#include "small_scene.h"

namespace {

using slidewave::dem::EnergyAudit;

double const g = 9.81;

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.17g", value);
  return buffer;
}

// A scene with one law for pairs and the floor, and its audit from `start()` on.
struct Audited : SmallScene {
  EnergyAudit audit;
  std::map<std::string, double> value;

  explicit Audited(std::string const& contacts, std::string const& floor_more = "")
      : audit(lmp(), true) {
    box("f f f");
    law(contacts);
    wall("floor", contacts, "primitive type 1 zplane 0" + floor_more);
    lines({"fix integrate all nve/sphere"});
  }
  void start(double dt_s) {
    lines({"timestep " + text(dt_s), "run 0"});
    look();
  }
  void run(long steps) {
    lines({"run " + std::to_string(steps)});
    look();
  }
  void look() {
    for (slidewave::Quantity const& quantity : audit.observe()) {
      value[quantity.name] = quantity.value;
    }
  }
  double kinetic() { return value["energy_translation_J"] + value["energy_rotation_J"]; }
};

TEST(EnergyAudit, ColumnsAreEmptyBeforeTheStart) {
  Audited scene("model linear kn 1e6");
  scene.sphere(5, 5, 1, 0.2);
  ASSERT_EQ(EnergyAudit::obstacle(scene.lmp()), "");
  scene.look();
  EXPECT_FALSE(std::isfinite(scene.value["energy_drift"]));
  EXPECT_FALSE(scene.audit.started());
  scene.start(1e-4);
  EXPECT_TRUE(std::isfinite(scene.value["energy_drift"]));
  EXPECT_EQ(scene.value.count("heat_rolling_J"), 0u) << "no rolling resistance, no column";
}

TEST(EnergyAudit, DashpotTakesWhatRestitutionLeaves) {
  double const zeta = 0.2;
  Audited scene("model linear kn 1e7 attraction on damping " + text(zeta));
  scene.sphere(5, 5, 0.101, 0.2);
  scene.set_velocity(1, "0 0 -1");
  double const before_J = 0.5 * scene.mass(1);
  scene.start(1e-6);
  scene.run(12000);
  double const e = std::exp(-std::acos(-1.0) * zeta / std::sqrt(1 - zeta * zeta));
  EXPECT_NEAR(scene.value["heat_damping_J"], before_J * (1 - e * e), 2e-3 * before_J);
  EXPECT_LT(std::abs(scene.value["energy_drift"]), 2e-3);
}

// Gross sliding: the tangential speed falls by mu (1 + e) v_n, the spin rises accordingly.
TEST(EnergyAudit, SlidingImpactHeats) {
  Audited scene("model linear kn 1e9 tangential coulomb ks 8e8 mu 0.2");
  scene.sphere(4.99, 5, 0.1005, 0.2);
  scene.set_velocity(1, "2 0 -0.5");
  double const m = scene.mass(1);
  scene.start(1e-6);
  double const before_J = scene.kinetic();
  scene.run(3000);
  double const change = 0.2 * 2 * 0.5;
  double const spin = 2.5 * change / 0.1;
  double const lost_J = 0.5 * m * (4 - std::pow(2 - change, 2) - 0.4 * 0.01 * spin * spin);
  EXPECT_NEAR(scene.value["heat_friction_J"], lost_J, 5e-3 * lost_J);
  EXPECT_NEAR(scene.kinetic(), before_J - lost_J, 5e-3 * lost_J);
  EXPECT_LT(std::abs(scene.value["energy_drift"]), 1e-4);
}

TEST(EnergyAudit, RollingResistanceTakesTheWholeMotion) {
  Audited scene(
      "model linear kn 1e7 tangential coulomb ks 8e6 mu 0.5 "
      "rolling_friction iwashita_oda kr 1e4 eta 0.05");
  scene.lines({"fix weight all gravity 9.81 vector 0 0 -1"});
  scene.sphere(4, 5, 0.1, 0.2);
  scene.set_velocity(1, "1 0 0");
  scene.set_spin(1, 0, 10, 0);
  scene.start(1e-4);
  double const before_J = scene.kinetic();
  scene.run(35000);
  EXPECT_NEAR(scene.value["heat_rolling_J"], before_J, 0.01 * before_J);
  EXPECT_LT(std::abs(scene.value["energy_drift"]), 1e-3);
}

// A wall that slides under a ball at rest: friction accelerates the ball at mu g; the wall does the
// work mu m g times its way, part becomes heat.
TEST(EnergyAudit, MovingWallWorks) {
  Audited scene("model linear kn 1e7 tangential coulomb ks 8e6 mu 0.1", " shear x 5");
  scene.lines({"fix weight all gravity 9.81 vector 0 0 -1"});
  scene.sphere(2, 5, 0.1, 0.2);
  double const depth = scene.mass(1) * g / 1e7;
  for (int i = 0; i < scene.lmp().atom->nlocal; ++i) {
    scene.lmp().atom->x[i][2] -= depth;
  }
  double const weight_N = scene.mass(1) * g;
  scene.start(1e-4);
  scene.run(2000);
  double const work_J = 0.1 * weight_N * 5 * 0.2;
  EXPECT_NEAR(scene.value["work_walls_J"], work_J, 0.01 * work_J);
  EXPECT_LT(std::abs(scene.value["energy_drift"]), 2e-3);
}

TEST(EnergyAudit, FluidWorkIsTheKineticEnergyItGives) {
  Audited scene("model linear kn 1e6");
  scene.sphere(5, 5, 5, 0.2);
  scene.lines({"fix fluid all slidewave drag 30 fluid_velocity 2 0 0 force 0 0 5 impulse"});
  scene.audit.add_fluid();
  scene.start(1e-3);
  scene.run(1000);
  EXPECT_GT(scene.kinetic(), 1.0);
  EXPECT_NEAR(scene.value["work_fluid_J"], scene.kinetic(), 1e-10 * scene.kinetic());
}

// 60 frictional spheres collapse: the books close, and a step near the one at which a pair alone is
// unstable is seen at once.
std::map<std::string, double> pile(double dt_s, double time_s) {
  Audited scene(
      "model linear kn 1e7 tangential coulomb ks 8e6 mu 0.5 "
      "rolling_friction jiang shape 0.2 crushing 2");
  scene.lines({"fix weight all gravity 9.81 vector 0.1 0 -1"});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.05, 0.05);
  for (int n = 0; n < 60; ++n) {
    scene.sphere(3 + 0.8 * (n % 4) + jitter(random), 3 + 0.8 * (n / 4 % 3) + jitter(random),
                 0.5 + 0.8 * (n / 12) + jitter(random), 0.7 + jitter(random));
  }
  scene.start(dt_s);
  scene.run(std::lround(time_s / dt_s));
  return scene.value;
}

TEST(EnergyAudit, PileClosesAndALongStepIsSeen) {
  auto const coarse = pile(8e-4, 0.8);  // 0.17 sqrt(m/kn) of the smallest
  auto const fine = pile(1e-4, 0.8);
  EXPECT_GT(fine.at("heat_friction_J"), 100);
  EXPECT_GT(fine.at("heat_rolling_J"), 1);
  EXPECT_LT(std::abs(fine.at("energy_drift")), 1e-3);
  EXPECT_LT(std::abs(coarse.at("energy_drift")), 0.02);
  double const critical = 2 / std::sqrt(2 * 1e7 / (2650 * 0.18));  // a pair along its normal
  EXPECT_GT(pile(0.5 * critical, 0.4).at("energy_drift"), EnergyAudit::warning);
  EXPECT_GT(pile(0.7 * critical, 0.4).at("energy_drift"), EnergyAudit::limit);
}

TEST(EnergyAudit, SaysWhyItCannotClose) {
  SmallScene scene;
  scene.box("f f f");
  scene.contacts(1e7, 8e6, 0.5);
  EXPECT_EQ(EnergyAudit::obstacle(scene.lmp()), "packaged contact law");
  Audited other("model linear kn 1e6");
  other.lines({"fix slow all viscous 5"});
  EXPECT_EQ(EnergyAudit::obstacle(other.lmp()), "nobody counts the work of fix viscous");
}

}  // namespace
