// Single-sphere coefficients against the table of PHYSICS.md 1.1 and terminal velocities of 3.2.
#include <gtest/gtest.h>

#include "slidewave/physics/brown_lawler.hpp"
#include "slidewave/physics/dalla_valle.hpp"
#include "slidewave/physics/schiller_naumann.hpp"
#include "slidewave/physics/single_sphere.hpp"
#include "slidewave/physics/stokes.hpp"
#include "terminal.hpp"

namespace slidewave {
namespace {

TEST(DragCoefficients, MatchTheTable) {
  struct Row {
    double re, dalla_valle, schiller_naumann;
  };
  for (Row const& row :
       {Row{0.1, 249.9, 247.4}, Row{1, 29.48, 27.60}, Row{10, 4.613, 4.151}, Row{100, 1.232, 1.092},
        Row{1000, .6112, .44}, Row{1e4, .4597, .44}, Row{1e5, .4163, .44}}) {
    EXPECT_NEAR(DallaValle::cd_re(row.re) / row.re / row.dalla_valle, 1, 5e-4) << row.re;
    EXPECT_NEAR(SchillerNaumann::cd_re(row.re) / row.re / row.schiller_naumann, 1, 5e-4) << row.re;
    EXPECT_EQ(Stokes::cd_re(row.re), 24);
  }
}

TEST(DragCoefficients, AreFiniteAtRest) {
  EXPECT_EQ(SchillerNaumann::cd_re(0), 24);
  EXPECT_NEAR(DallaValle::cd_re(0), 23.04, 1e-12);
  EXPECT_EQ(BrownLawler::cd_re(0), 24);
}

template <class Coefficient>
double speed_mm_s(double d_m, double rho_s, double rho_f, double mu) {
  return 1e3 * terminal_speed<SingleSphere<Coefficient>>({d_m, 0, rho_f, mu, 1}, rho_s, 9.81);
}

TEST(DragCoefficients, GiveTerminalVelocities) {
  EXPECT_NEAR(speed_mm_s<DallaValle>(100e-6, 2650, 1000, 0.1), .0934, .0001);
  EXPECT_NEAR(speed_mm_s<SchillerNaumann>(100e-6, 2650, 1000, 0.1), .0899, .0001);
  EXPECT_NEAR(speed_mm_s<DallaValle>(1e-3, 2650, 1000, 1e-3), 142.3, 0.1);
  EXPECT_NEAR(speed_mm_s<SchillerNaumann>(1e-3, 2650, 1000, 1e-3), 155.1, 0.1);
  EXPECT_NEAR(speed_mm_s<DallaValle>(3e-3, 2650, 1000, 1e-3), 324.6, 0.1);
  EXPECT_NEAR(speed_mm_s<SchillerNaumann>(3e-3, 2650, 1000, 1e-3), 383.6, 1.6);  // Re 1139
  EXPECT_NEAR(speed_mm_s<DallaValle>(100e-6, 3000, 10, 1e-4), 128.6, 0.1);
  EXPECT_NEAR(speed_mm_s<SchillerNaumann>(100e-6, 3000, 10, 1e-4), 137.4, 0.1);
  EXPECT_NEAR(speed_mm_s<DallaValle>(2.8, 2650, 1000, 1e-3), 12320, 10);
  EXPECT_NEAR(speed_mm_s<SchillerNaumann>(2.8, 2650, 1000, 1e-3), 11720, 10);
  EXPECT_NEAR(speed_mm_s<Stokes>(100e-6, 2650, 1000, 0.1), 0.0899250, 1e-7);
}

}  // namespace
}  // namespace slidewave
