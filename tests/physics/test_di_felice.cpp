// Brown-Lawler and Di Felice against typed-in numbers of PHYSICS.md 0.2, 1.1, 3.2 and closed cases.
#include <gtest/gtest.h>

#include <cmath>

#include "slidewave/physics/brown_lawler.hpp"
#include "slidewave/physics/clump.hpp"
#include "slidewave/physics/di_felice.hpp"
#include "terminal.hpp"

namespace slidewave {
namespace {

using Law = DiFelice<BrownLawler>;

TEST(BrownLawler, MatchesTheTable) {
  double const table[][2] = {{0.1, 247.5},  {1, 27.60},   {10, 4.128}, {100, 1.073},
                             {1000, .4634}, {1e4, .4106}, {1e5, .4661}};
  for (auto const& row : table) {
    EXPECT_NEAR(BrownLawler::cd_re(row[0]) / row[0] / row[1], 1, 5e-4) << row[0];
  }
  EXPECT_EQ(BrownLawler::cd_re(0), 24);
}

TEST(DiFelice, ExponentHasItsRange) {
  EXPECT_NEAR(di_felice_exponent(std::pow(10, 1.5)), 3.05, 1e-12);
  EXPECT_NEAR(di_felice_exponent(0), 3.7, 1e-12);
  EXPECT_NEAR(di_felice_exponent(1e8), 3.7, 1e-6);
}

TEST(DiFelice, IsStokesAloneAndAtRest) {
  Grain const grain{1e-3, 0, 1000, 1e-3, 1};
  EXPECT_NEAR(Law::drag(grain), 9.42477796076938e-6, 1e-18);  // 3 pi mu d
}

TEST(DiFelice, TerminalSpeeds) {
  auto speed = [](double d, double rho_s, double rho, double mu) {
    return terminal_speed<Law>({d, 0, rho, mu, 1}, rho_s, 9.81);
  };
  EXPECT_NEAR(speed(100e-6, 2650, 1000, 0.1), 0.08993e-3, 0.0001e-3);  // Stokes: 0.089925
  EXPECT_NEAR(speed(1e-3, 2650, 1000, 1e-3), 156.8e-3, 0.1e-3);
  EXPECT_NEAR(speed(3e-3, 2650, 1000, 1e-3), 379.5e-3, 0.1e-3);
  EXPECT_NEAR(speed(15e-3, 1120, 970, 0.373), 40.9e-3, 0.1e-3);
  EXPECT_NEAR(speed(15e-3, 1120, 965, 0.212), 63.7e-3, 0.1e-3);
  EXPECT_NEAR(speed(15e-3, 1120, 962, 0.113), 94.3e-3, 0.1e-3);
  EXPECT_NEAR(speed(15e-3, 1120, 960, 0.058), 130.1e-3, 0.1e-3);
  EXPECT_NEAR(speed(2.8, 2650, 1000, 1e-3), 11.98, 0.01);  // a Vajont rock
}

TEST(DiFelice, VoidageActsOnInterstitialSlipByTwoMinusChi) {
  // Where Cd is flat within 1 % (Re 1e8) force ~ eps^(2 - 3.7) at equal interstitial slip.
  Grain dense{1, 100, 1000, 1e-3, 0.4};
  Grain dilute = dense;
  dilute.void_fraction = 1;
  double const ratio = Law::drag(dense) / Law::drag(dilute);
  EXPECT_NEAR(ratio, 4.748, 0.048);  // 0.4^-1.7
  // B's total force is 1/eps of A's: 2.5 times at eps = 0.4.
  EXPECT_NEAR(in_formulation(Formulation::B, ratio, 0.4) / ratio, 2.5, 1e-12);
}

TEST(Clump, ForceOfAlphaCubedGrainsIsAlphaTimesTheParticlesAtTheGrainsReynolds) {
  // alpha^3 F(d, Re_d) = alpha F(D) with Cd and chi taken at Re_d (PHYSICS.md 0.5).
  for (double const alpha : {1.0, 2.0, 5.0, 10.0}) {
    double const large = 2.8, slip = 3.0, rho = 1000, mu = 1e-3, eps = 0.45;
    double const small = grain_diameter(large, alpha);
    double const sum = grains_per_particle(alpha) * Law::drag({small, slip, rho, mu, eps}) * slip;
    double const re = eps * rho * slip * small / mu;
    double const cd = BrownLawler::cd_re(re) / re;
    double const force = M_PI / 8 * large * large * rho * cd * slip * slip *
                         std::pow(eps, 2 - di_felice_exponent(re));
    EXPECT_NEAR(sum / (alpha * force), 1, 1e-12);
  }
}

TEST(DiFelice, IsFiniteAndContinuousOverItsRange) {
  for (double eps = 0.15; eps <= 1; eps += 0.05) {
    double last = Law::drag({1e-3, 0, 1000, 1e-3, eps});
    for (double slip = 1e-12; slip < 2e5; slip *= 1.01) {
      double const drag = Law::drag({1e-3, slip, 1000, 1e-3, eps});
      ASSERT_TRUE(std::isfinite(drag));
      ASSERT_NEAR(drag / last, 1, 0.03) << eps << " " << slip;
      last = drag;
    }
  }
}

}  // namespace
}  // namespace slidewave
