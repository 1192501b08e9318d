// The other limits against numbers typed in from PHYSICS.md and against small experiments.
#include <gtest/gtest.h>

#include <cmath>

#include "slidewave/physics/limits/added_mass_number.hpp"
#include "slidewave/physics/limits/capillary.hpp"
#include "slidewave/physics/limits/cost.hpp"
#include "slidewave/physics/limits/courant.hpp"
#include "slidewave/physics/limits/drag_response.hpp"
#include "slidewave/physics/limits/gravity_wave.hpp"
#include "slidewave/physics/limits/resolution.hpp"

namespace slidewave {
namespace {

/// Columns of spheres that settle in the mild regime, with both engines (docs/stability.md).
TEST(Limits, MildRegimeByCrowding) {
  struct Seen {
    double solid_fraction, x;
    bool right;
  };
  for (Seen const seen : {Seen{.5, 1.83, false}, Seen{.6, .40, true}, Seen{.64, .489, false},
                          Seen{.7, .30, false}, Seen{.74, .15, false}, Seen{.74, .10, true}}) {
    EXPECT_EQ(seen.x <= limits::largest_mild_stiffness(seen.solid_fraction), seen.right)
        << seen.solid_fraction << ' ' << seen.x;
  }
}

TEST(AddedMassNumber, RockAndWater) {
  // PHYSICS.md 0.10: phi .60: 0.57; .74: 1.07; neutrally buoyant at .6: 1.5; air 4e-4 or so.
  EXPECT_NEAR(limits::added_mass_number(.60, 2650, 1000), 0.57, 0.005);
  EXPECT_NEAR(limits::added_mass_number(.74, 2650, 1000), 1.07, 0.005);
  EXPECT_NEAR(limits::added_mass_number(.60, 1000, 1000), 1.5, 1e-12);
  EXPECT_LT(limits::added_mass_number(.60, 2650, 1.225), 1e-3);
}

TEST(AddedMassNumber, LimitsLieBetweenWhatRanAndWhatBlewUp) {
  // Both engines, closed columns, the least density ratio that ran and the greatest that did not
  // (docs/stability.md): S = phi/(eps ratio).
  EXPECT_LT(limits::mild_added_mass_number, limits::added_mass_number(.5, 300, 1000));
  EXPECT_LT(limits::mild_added_mass_number, limits::added_mass_number(.5, 200, 1000));
  EXPECT_LE(limits::stiff_added_mass_number, limits::added_mass_number(.6, 1000, 1000) + 1e-12);
  EXPECT_LT(limits::stiff_added_mass_number, limits::added_mass_number(.6, 900, 1000));
}

TEST(GravityWave, ExplicitSurfaceOfTheShortestWave) {
  // Deep water, w^2 = g k, k = pi/dx; level and velocity stepped one after the other blow up
  // above 2.
  double const w = limits::shortest_wave_rate(9.81, 0.02);
  EXPECT_NEAR(w * w, 9.81 * M_PI / 0.02, 1e-9);
  for (double const turn : {limits::largest_wave_turn, 2.1}) {
    double level = 1, rate = 0;
    for (int n = 0; n < 300; ++n) {
      rate -= turn * level;
      level += turn * rate;
    }
    EXPECT_EQ(std::abs(level) > 1e3, turn > 2) << turn;
  }
}

TEST(AddedMassNumber, VirtualMassInAColumn) {
  // The coupling's order, without drag: the fluid sees the particles' motion a window late, solves
  // its momentum equation for the pressure gradient, and the particles move under it. What virtual
  // mass took from the particles is repaid to the fluid a window later.
  double const phi = 0.5, eps = 1 - phi, rho = 1000, rho_s = 2650;
  for (double const c : {0.0, 0.5, 2.0}) {
    for (bool const shares : {true, false}) {
      double const before = 1, fluid = -phi / eps * before;
      double const reaction = phi * c * rho * (fluid - before);
      double const gradient = -rho * fluid - reaction / eps;
      double const after = ((shares ? -gradient : 0) + c * rho * fluid) / (rho_s + c * rho);
      EXPECT_NEAR(-after, limits::added_mass_number(phi, rho_s, rho, c, shares), 1e-12) << c;
    }
  }
}

TEST(DragResponse, MixtureRelaxesFasterByItsLoading) {
  // Two momentum equations integrated finely: slip decays at K/m (1 + loading).
  double const k = 3, m = 2, fluid_mass = 0.5, time = 0.2;
  double v = 1, u = 0;
  int const steps = 2000000;
  for (int i = 0; i < steps; ++i) {
    double const impulse = k * (u - v) * time / steps;
    v += impulse / m;
    u -= impulse / fluid_mass;
  }
  double const x = limits::stiffness(k, time, m);
  EXPECT_NEAR(v - u, std::exp(-limits::mixture_stiffness(x, m / fluid_mass)), 1e-6);
  EXPECT_NEAR(limits::loading(.6, 2650, 1000), 3.975, 1e-12);
  EXPECT_NEAR(limits::response_time(m, k), 2.0 / 3, 1e-15);
}

TEST(Capillary, PublishedFigure) {
  // PHYSICS.md 4.7: 5 mm, 0.07 N/m, water and air: 1.2e-2 s.
  EXPECT_NEAR(limits::capillary_step(1000, 1.2, 5e-3, 0.07), 1.2e-2, 0.05e-2);
  EXPECT_TRUE(std::isinf(limits::capillary_step(1000, 1.2, 5, 0)));
}

TEST(Courant, PaperStepIsFarBelowItsLimit) {
  // PHYSICS.md 0.6: 1e-3 s at 5 m cells and 40 m/s is 0.008.
  EXPECT_NEAR(limits::courant(40, 1e-3, 5), 0.008, 1e-12);
  EXPECT_NEAR(limits::courant(40, limits::courant_step(0.5, 40, 5), 5), 0.5, 1e-12);
  EXPECT_TRUE(std::isinf(limits::courant_step(0.5, 0, 5)));
}

TEST(Resolution, LengthsFollowTheLarger) {
  EXPECT_EQ(limits::smoothing_length(4, 1), 6);
  EXPECT_EQ(limits::smoothing_length(1, 4), 6);
  EXPECT_EQ(limits::periodic_width(7.6), 15.2);  // the dry trial of VAJONT.md
  EXPECT_GT(limits::periodic_width(7.6, true), 7.6);
  EXPECT_LT(limits::periodic_width(7.6, true), 1.01 * 7.6);
  EXPECT_EQ(limits::cell_per_diameter(10, 4), 2.5);
}

TEST(Cost, FullPaperRun) {
  // PHYSICS.md 0.8: 1e7 steps of 2.3e4 grains are 2.3e11 particle-steps.
  limits::UnitCosts costs;
  costs.particle_steps_per_s = 1e6;
  EXPECT_NEAR(limits::particle_seconds(costs, 2.3e4, 1e7), 2.3e5, 1);
  costs.cell_steps_per_s = 1e5;
  EXPECT_NEAR(limits::cell_seconds(costs, 1e4, 100), 10, 1e-12);
  EXPECT_GT(limits::memory_bytes(costs, 1e6, 1e6, 4), limits::memory_bytes(costs, 1e6, 0, 4));
}

}  // namespace
}  // namespace slidewave
