// Virtual mass, volume forces, mixtures, lift and rotational drag: limits known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "slidewave/physics/added_mass.hpp"
#include "slidewave/physics/exponential_kick.hpp"
#include "slidewave/physics/mixture.hpp"
#include "slidewave/physics/rotational_drag.hpp"
#include "slidewave/physics/saffman_mei.hpp"
#include "slidewave/physics/volume_forces.hpp"

namespace slidewave {
namespace {

using Eigen::Vector3d;

TEST(AddedMass, GrainInAcceleratingFluid) {
  // F5: (m + m_a) dv/dt = -V grad p + m_a Du/Dt, grad p = -rho_f a:
  // dv/dt = a (1 + C)/(rho_s/rho_f + C); a neutral grain follows the fluid.
  double const c = added_mass_coefficient(1), volume = 2e-9, a = 3;
  EXPECT_EQ(c, 0.5);
  for (double const ratio : {0.1, 1.0, 2.65}) {
    double const mass = 1000 * ratio * volume, extra = added_mass(c, 1000, volume);
    Vector3d const pressure = pressure_gradient_force(volume, Vector3d(-1000 * a, 0, 0));
    double const acceleration = (pressure(0) + extra * a) / (mass + extra);
    EXPECT_NEAR(acceleration, a * 1.5 / (ratio + 0.5), 1e-12);
  }
  EXPECT_NEAR(added_mass_coefficient(0.6), 1.5, 1e-12);  // 0.5 (1 + 0.8)/0.6
  EXPECT_TRUE(std::isfinite(added_mass_coefficient(0)));
}

TEST(VolumeForces, BuoyancyFromHydrostaticsEqualsArchimedes) {
  Vector3d const g(0, 0, -9.81);
  Vector3d const pressure = pressure_gradient_force(0.3, 1000 * g);  // grad p = rho g at rest
  EXPECT_NEAR((pressure - archimedes_force(0.3, 1000, g)).norm(), 0, 1e-10);
  EXPECT_NEAR(pressure(2), 2943, 1e-9);
  EXPECT_NEAR(viscous_force(0.3, Vector3d(0, 10, 0))(1), 3, 1e-12);
}

TEST(Mixture, EndsAndOrder) {
  EXPECT_EQ(mixture(1, 1000, 1.225), 1000);
  EXPECT_EQ(mixture(-1e-9, 1000, 1.225), 1.225);
  EXPECT_NEAR(mixture(0.25, 1000, 2), 251.5, 1e-12);
  EXPECT_NEAR(harmonic_mixture(0.5, 1e-3, 3e-3), 1.5e-3, 1e-18);
}

TEST(SaffmanMei, StrongShearIsSaffman) {
  // s -> infinity: F = 1.615 mu d^2 |U| sqrt(G/nu), to the faster fluid for a lagging grain.
  double const d = 1e-4, rho = 1000, mu = 1, shear = 100, slip = 1e-4;
  Vector3d const lift = saffman_mei_lift(d, rho, mu, Vector3d(slip, 0, 0), Vector3d(0, 0, -shear));
  EXPECT_NEAR(lift(1) / (1.615 * mu * d * d * slip * std::sqrt(shear * rho / mu)), 1, 1e-3);
  EXPECT_EQ(lift(0), 0);
  EXPECT_EQ(lift(2), 0);
}

TEST(SaffmanMei, FactorIsContinuousAndBounded) {
  double last = mei_factor(1e-6);
  for (double s = 1e-6; s < 1e6; s *= 1.002) {
    double const factor = mei_factor(s);
    ASSERT_NEAR(factor, last, 4e-3) << s;
    ASSERT_LT(factor, 1.001);
    ASSERT_GT(factor, -0.02);
    last = factor;
  }
  EXPECT_EQ(mei_factor(0), 0);
}

TEST(SaffmanMei, VanishesAtRestAndWithoutShear) {
  EXPECT_EQ(saffman_mei_lift(1e-3, 1000, 1e-3, Vector3d::Zero(), Vector3d::UnitX()).norm(), 0);
  EXPECT_EQ(saffman_mei_lift(1e-3, 1000, 1e-3, Vector3d::UnitX(), Vector3d::Zero()).norm(), 0);
}

TEST(RotationalDrag, SpinDecaysAtItsClosedFormRate) {
  // 8 pi mu r^3 over 2/5 m r^2: rate 60 mu/(rho_s d^2), through the exponential kick.
  double const d = 2e-3, mu = 0.02, rho_s = 2650, time = 0.03;
  double const inertia = 0.1 * rho_s * M_PI / 6 * std::pow(d, 5);
  auto const kicked = exponential_kick(7.0, 0.0, rotational_drag(d, mu), 0.0, inertia, time);
  EXPECT_NEAR(kicked.velocity, 7 * std::exp(-60 * mu / (rho_s * d * d) * time), 1e-12);
}

}  // namespace
}  // namespace slidewave
