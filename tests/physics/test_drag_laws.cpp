// Drag laws in beds and suspensions: typed-in values, pressure drops, fluidisation, settling
// slopes. References: PHYSICS.md 0.2 (ratios and slopes), 1.2 (U_mf), 3.3 (simple cubic packing),
// and values worked out from the published formulas outside this code.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "slidewave/physics/beetstra.hpp"
#include "slidewave/physics/brown_lawler.hpp"
#include "slidewave/physics/dalla_valle.hpp"
#include "slidewave/physics/di_felice.hpp"
#include "slidewave/physics/ergun.hpp"
#include "slidewave/physics/gidaspow.hpp"
#include "slidewave/physics/koch_hill.hpp"
#include "slidewave/physics/rong.hpp"
#include "slidewave/physics/wen_yu.hpp"
#include "terminal.hpp"

namespace slidewave {
namespace {

using DiFeliceDallaValle = DiFelice<DallaValle>;

/// A grain of 1 mm in water at a superficial Reynolds number.
Grain grain_at(double reynolds, double eps) {
  return {1e-3, reynolds * 1e-3 / (eps * 1000 * 1e-3), 1000, 1e-3, eps};
}

template <class Law>
double over_stokes(double reynolds, double eps) {
  return Law::drag(grain_at(reynolds, eps)) / (3 * M_PI * 1e-3 * 1e-3);
}

/// Pressure drop per length of a uniform bed: eps dp/L = n f_A, n grains a volume.
template <class Law>
double pressure_drop(Grain const& grain) {
  double const grains = (1 - grain.void_fraction) / (M_PI / 6 * std::pow(grain.diameter_m, 3));
  return grains * Law::drag(grain) * grain.slip_m_s / grain.void_fraction;
}

// eps .45, .7, .9, each at Re .01, 10, 500: K over the Stokes drag of a lone grain.
using Values = std::array<double, 9>;

template <class Law>
void expect_values(Values const& values) {
  int i = 0;
  for (double const eps : {.45, .7, .9}) {
    for (double const re : {.01, 10.0, 500.0}) {
      EXPECT_NEAR(over_stokes<Law>(re, eps) / values[i], 1, 1e-4) << Law::name << i;
      ++i;
    }
  }
}

TEST(DragLaws, TypedInValues) {
  expect_values<KochHill>({12.224, 13.681, 85.181, 4.6249, 5.2832, 37.569, 2.2873, 2.8044, 28.164});
  expect_values<Beetstra>({12.415, 13.636, 87.995, 4.9105, 5.7956, 42.146, 2.1861, 2.8963, 24.347});
  expect_values<WenYu>({8.3509, 14.353, 97.274, 2.5896, 4.4508, 30.165, 1.3305, 2.2867, 15.498});
  expect_values<Ergun>({10.187, 12.346, 118.21, 3.5728, 4.9603, 73.016, .92701, 2.0062, 54.938});
  expect_values<Rong<DallaValle>>(
      {9.5229, 10.932, 107.25, 3.436, 4.3236, 40.704, 1.5068, 2.5011, 20.793});
  expect_values<DiFeliceDallaValle>(
      {8.5002, 10.501, 99.677, 2.58, 4.1039, 34.777, 1.3094, 2.405, 19.106});
}

TEST(DragLaws, ErgunGivesItsPressureDrop) {
  // 150 mu (1-e)^2 U/(e^3 d^2) + 1.75 rho (1-e) U^2/(e^3 d) at e = .4, d = 1 mm, U = 10 mm/s, water
  EXPECT_NEAR(pressure_drop<Ergun>(grain_at(10, 0.4)), 8437.5 + 1640.625, 1e-8);
}

TEST(DragLaws, DiFeliceAgainstErgun) {
  struct Row {
    double eps, re, ratio;
  };
  for (Row const& row :
       {Row{.40, .1, .96}, Row{.40, 1, .94}, Row{.40, 10, .90}, Row{.40, 100, .98},
        Row{.45, .1, .86}, Row{.45, 1, .86}, Row{.45, 10, .85}, Row{.45, 100, .88}}) {
    Grain const grain = grain_at(row.re, row.eps);
    EXPECT_NEAR(pressure_drop<DiFeliceDallaValle>(grain) / pressure_drop<Ergun>(grain), row.ratio,
                0.006);
  }
}

TEST(DragLaws, SimpleCubicPacking) {
  // One grain of 2.5 mm a cube of its size, eps = 1 - pi/6, 1000 Pa/m: superficial speed solved
  // outside this code from the superficial form f0 eps^-chi, so the exponent is tested too.
  double const eps = 1 - M_PI / 6;
  Grain const dalla_valle{2.5e-3, 0.011703746459569066 / eps, 998.23, 1.004e-3, eps};
  EXPECT_NEAR(pressure_drop<DiFeliceDallaValle>(dalla_valle), 1000, 1e-9 * 1000);
  Grain const brown_lawler{2.5e-3, 0.012718258776684975 / eps, 998.23, 1.004e-3, eps};
  EXPECT_NEAR(pressure_drop<DiFelice<BrownLawler>>(brown_lawler), 1000, 1e-9 * 1000);
}

template <class Law>
double fluidisation_mm_s(double d_m) {
  // K w = eps V (rho_s - rho) g; superficial speed eps w.
  double const eps = 0.42;
  Grain grain{d_m, 0, 1000, 1e-3, eps};
  double const weight = eps * M_PI / 6 * d_m * d_m * d_m * 1650 * 9.81;
  double low = 0, high = 1;
  for (int i = 0; i < 100; ++i) {
    grain.slip_m_s = (low + high) / 2;
    (Law::drag(grain) * grain.slip_m_s < weight ? low : high) = grain.slip_m_s;
  }
  return 1e3 * eps * low;
}

TEST(DragLaws, MinimumFluidisation) {
  EXPECT_NEAR(fluidisation_mm_s<Ergun>(1e-3), 11.24, 0.01);
  EXPECT_NEAR(fluidisation_mm_s<Ergun>(3e-3), 37.8, 0.1);
  EXPECT_NEAR(fluidisation_mm_s<DiFeliceDallaValle>(1e-3), 12.47, 0.01);
  EXPECT_NEAR(fluidisation_mm_s<DiFeliceDallaValle>(3e-3), 39.3, 0.1);
}

/// Richardson-Zaki exponent between eps = 1 and eps: v = v_t eps^n, closed column, f_A carries
/// eps of the submerged weight.
template <class Law>
double settling_exponent(double d_m, double rho_s, double mu, double eps) {
  Grain grain{d_m, 0, 1000, mu, 1};
  double const alone = terminal_speed<Law>(grain, rho_s, 9.81);
  grain.void_fraction = eps;
  double const hindered = eps * terminal_speed<Law>(grain, 1000 + (rho_s - 1000) * eps, 9.81);
  return std::log(hindered / alone) / std::log(eps);
}

TEST(DragLaws, HinderedSettlingSlopes) {
  // Stokes: chi = 3.7 exactly, so n = 1 + 1 - (1 - 3.7) = 4.70.
  EXPECT_NEAR(settling_exponent<DiFeliceDallaValle>(10e-6, 2650, 0.1, 0.7), 4.70, 0.02);
  for (double const eps : {0.6, 0.7, 0.8, 0.9}) {  // 1 mm in water, Re_t = 142
    double const n = settling_exponent<DiFeliceDallaValle>(1e-3, 2650, 1e-3, eps);
    EXPECT_GT(n, 2.55) << eps;
    EXPECT_LT(n, 2.75) << eps;
    double const fast = settling_exponent<DiFeliceDallaValle>(3e-3, 2650, 1e-3, eps);  // Re_t 974
    EXPECT_GT(fast, 2.40) << eps;
    EXPECT_LT(fast, 2.52) << eps;
  }
}

TEST(DragLaws, FormulationsGiveTheSameTotalForceInABed) {
  // A: f_A - V grad p, grad p = -n f_A/eps;  B: f_B alone (no gravity).
  for (double const eps : {0.3, 0.5, 0.8}) {
    Grain const grain = grain_at(20, eps);
    double const volume = M_PI / 6 * 1e-9;
    double const f_a = KochHill::drag(grain) * grain.slip_m_s;
    double const total_a = f_a + volume * pressure_drop<KochHill>(grain);
    double const total_b =
        in_formulation(Formulation::B, KochHill::drag(grain), eps) * grain.slip_m_s;
    EXPECT_NEAR(total_a / total_b, 1, 1e-14);
  }
}

TEST(DragLaws, GidaspowIsErgunInBedsAndWenYuInDiluteFlow) {
  EXPECT_NEAR(over_stokes<Gidaspow>(10, 0.45) / over_stokes<Ergun>(10, 0.45), 1, 2e-3);
  EXPECT_NEAR(over_stokes<Gidaspow>(10, 0.99) / over_stokes<WenYu>(10, 0.99), 1, 1e-2);
}

TEST(DragLaws, LatticeBoltzmannLawsAreStokesForALoneGrain) {
  EXPECT_NEAR(over_stokes<KochHill>(0, 1), 1, 1e-12);
  EXPECT_NEAR(over_stokes<Beetstra>(0, 1), 1, 1e-12);
}

}  // namespace
}  // namespace slidewave
