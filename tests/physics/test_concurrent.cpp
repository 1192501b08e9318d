// The concurrent scheme in a uniform mixture: the slip from window to window, ledger included.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "slidewave/physics/limits/concurrent.hpp"

namespace slidewave {
namespace {

/// Slips of successive windows over the first, for b = K W/m and the mass loading, from the two
/// momenta as the scheme exchanges them.
std::vector<double> slips(double b, double loading, int windows) {
  double u = 1, v = 0, ledger = 0;  // fluid mass 1, particle mass `loading`
  std::vector<double> found;
  for (int n = 0; n < windows; ++n) {
    double const slip = u - v;
    found.push_back(slip);
    double const given = b * loading * slip - ledger;
    double const received = -std::expm1(-b) * loading * slip;
    u -= given;
    v += received / loading;
    ledger += given - received;
  }
  EXPECT_NEAR(u + loading * v + ledger, 1, 1e-9);
  return found;
}

TEST(Concurrent, SlipsFallWithinTheLimits) {
  for (double b : {0.01, 0.1, limits::concurrent_particle_stiffness}) {
    for (double a : {1e-3, 0.05, limits::concurrent_fluid_stiffness}) {
      auto const slip = slips(b, a / b, 40);
      for (std::size_t n = 1; n < slip.size(); ++n) {
        EXPECT_GT(slip[n], 0) << a << " " << b;
        EXPECT_LT(slip[n], slip[n - 1]) << a << " " << b;
      }
    }
  }
}

TEST(Concurrent, BeyondThemTheyTurnAndGrow) {
  EXPECT_LT(slips(0.5, 3, 2)[1], 0);  // exp(-0.5) < 1.5
  auto const slip = slips(31, 0.0224, 20);
  for (std::size_t n = 1; n < slip.size(); ++n) {
    EXPECT_LT(slip[n] * slip[n - 1], 0);
  }
  EXPECT_NEAR(slip[19] / slip[18], -1.238, 1e-2);  // as the two fakes do (pair.concurrent)
}

}  // namespace
}  // namespace slidewave
