// The kick against a fine explicit integration, long double closed forms and steady settling.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "slidewave/physics/exponential_kick.hpp"

namespace slidewave {
namespace {

TEST(KickFactors, MatchLongDoubleSeriesAndClosedForm) {
  for (double x = 1e-12; x < 2e6; x *= 1.7) {
    long double const exact_phi1 = -std::expm1((long double)-x) / x;
    long double exact_phi2 = (1 - exact_phi1) / x;
    if (x < 1e-3) {
      long double const y = x;
      exact_phi2 = 0.5L - y / 6 + y * y / 24 - y * y * y / 120 + y * y * y * y / 720;
    }
    KickFactors const factors = kick_factors(x);
    EXPECT_NEAR(factors.phi1 / double(exact_phi1), 1, 1e-15) << x;
    EXPECT_NEAR(factors.phi2 / double(exact_phi2), 1, 5e-15) << x;
  }
  EXPECT_EQ(kick_factors(0.0).phi1, 1);
  EXPECT_EQ(kick_factors(0.0).phi2, 0.5);
}

TEST(ExponentialKick, MatchesFineIntegrationOfTheEquation) {
  double const m = 2.5, h = 0.3, u = -1.2, force = 7.0, v0 = 3.1;
  for (double const drag : {0.0, 1e-6, 0.4, 8.0, 90.0}) {
    int const steps = 200000;  // midpoint rule: error ~ (x/steps)^2
    long double v = v0, impulse = 0;
    for (int i = 0; i < steps; ++i) {
      long double const tau = (long double)h / steps;
      long double const middle = v + tau / 2 * (drag * (u - v) + force) / m;
      v += tau * (drag * (u - middle) + force) / m;
      impulse += tau * drag * (u - middle);
    }
    Kicked<double> const kicked = exponential_kick(v0, u, drag, force, m, h);
    EXPECT_NEAR(kicked.velocity, double(v), 1e-9) << drag;
    EXPECT_NEAR(kicked.drag_impulse, double(impulse), 1e-8) << drag;
  }
}

TEST(ExponentialKick, ImpulsesAddUpToTheMomentumGained) {
  Eigen::Vector3d const v(3, -200, 1e-3), u(-1, 5, 0), force(1e4, -2e4, 3);
  double const m = 40, h = 1e-3;
  for (double x = 1e-12; x < 2e6; x *= 10) {
    auto const kicked = exponential_kick(v, u, x * m / h, force, m, h);
    Eigen::Vector3d const left = kicked.drag_impulse + force * h;
    Eigen::Vector3d const right = m * (kicked.velocity - v);
    EXPECT_LT((left - right).norm(), 1e-12 * (m * v.norm() + force.norm() * h)) << x;
  }
}

TEST(ExponentialKick, SmallDragGivesItsExplicitImpulseToFirstOrder) {
  // J -> K h (u - v): must not drown in the cancellation of m dv - F h.
  double const k = 1e-12;
  auto const kicked = exponential_kick(2.0, 5.0, k, 1e6, 1.0, 1e-9);
  EXPECT_NEAR(kicked.drag_impulse / (k * 1e-9 * (3.0 - 0.5e-3)), 1, 1e-12);
}

TEST(ExponentialKick, TwoHalvesMakeAWhole) {
  for (double const k : {1e-6, 1.0, 50.0, 1e5}) {
    auto const whole = exponential_kick(4.0, -1.0, k, 9.0, 2.0, 0.2);
    auto const first = exponential_kick(4.0, -1.0, k, 9.0, 2.0, 0.1);
    auto const second = exponential_kick(first.velocity, -1.0, k, 9.0, 2.0, 0.1);
    EXPECT_NEAR(second.velocity, whole.velocity, 1e-13);
    EXPECT_NEAR(first.drag_impulse + second.drag_impulse, whole.drag_impulse, 1e-12);
  }
}

TEST(ExponentialKick, SettlesAtWeightOverDragAsForceHook) {
  // As an engine uses it: two half kicks a step, each through the force that f h/m turns into dv.
  double const m = 0.7, weight = -0.7 * 9.81, dt = 1e-3, u = 0.4;
  for (double x = 1e-3; x < 2e4; x *= 10) {
    double const drag = x * m / dt;
    KickFactors const factors = kick_factors(drag, m, dt / 2);
    double v = 30;
    for (int half = 0; half < 2 * (50 + int(50 / x)); ++half) {
      v += effective_force(factors, drag, u, v, weight) * dt / 2 / m;
    }
    double const slip = weight / drag;
    EXPECT_NEAR((v - u) / slip, 1, 1e-10 + 1e-15 * std::abs(u / slip)) << x;
  }
}

TEST(ExponentialKick, IsNotTheSplit) {
  // Drag after gravity would leave the slip at g dt e^-x: at x = 10 the settling speed is far off.
  auto const kicked = exponential_kick(0.0, 0.0, 10.0, -9.81, 1.0, 1.0);
  EXPECT_NEAR(kicked.velocity, -0.981 * (1 - std::exp(-10.0)), 1e-12);
}

}  // namespace
}  // namespace slidewave
