#include <gtest/gtest.h>

#include "budgets.hpp"

using namespace slidewave;

namespace {

/// A window in which the fluid gives 3, the particles receive 2, and the ledger rises by 1.
struct Case {
  DemSums dem;
  FluidSums fluid;
  Case() {
    dem.particles = 10;
    dem.mass_kg = 5;
    dem.volume_m3 = 2;
    dem.received[0] = 2;
    dem.received_abs = 2;
    dem.ledger[0] = 1;
    fluid.given[0] = 3;
    fluid.solid_volume_m3 = 2;
  }
};

double column(Budgets const& budgets, std::string const& name) {
  for (Quantity const& quantity : budgets.columns()) {
    if (quantity.name == name) {
      return quantity.value;
    }
  }
  ADD_FAILURE() << "no column " << name;
  return 0;
}

}  // namespace

TEST(Budgets, CloseWhenLedgerIsTheDifference) {
  Case window;
  Budgets budgets(Models(), Vec3::Ones());
  budgets.add(0.1, 10, window.dem, window.fluid);
  EXPECT_EQ(budgets.momentum_defect(), 0);
  EXPECT_NEAR(budgets.momentum_outstanding(), 1 / (2 + 5 * 10 * 0.1), 1e-15);
  EXPECT_EQ(budgets.solid_volume_defect(), 0);
}

TEST(Budgets, ErrorsOfTwoWindowsDoNotCancel) {
  Case window;
  Budgets budgets(Models(), Vec3::Ones());
  window.fluid.given[0] = 3.5;
  budgets.add(0.1, 10, window.dem, window.fluid);
  window.fluid.given[0] = 1.5;  // the ledger stays: 2 expected
  budgets.add(0.1, 10, window.dem, window.fluid);
  EXPECT_NEAR(budgets.momentum_defect(), 1.0 / 4, 1e-15);
}

TEST(Budgets, AnAxisThatIsNotSolvedIsReportedApart) {
  Case window;
  window.dem.received[1] = 7;
  Budgets open(Models(), Vec3::Ones());
  open.add(0.1, 10, window.dem, window.fluid);
  EXPECT_GT(open.momentum_defect(), 1);
  Budgets slab(Models(), Vec3(1, 0, 1));
  slab.add(0.1, 10, window.dem, window.fluid);
  EXPECT_EQ(slab.momentum_defect(), 0);
  EXPECT_EQ(column(slab, "constraint_impulse_kg_m_s"), 7);
}

TEST(Budgets, SeeLostVolumePressureAndParticles) {
  Case window;
  Budgets budgets(Models(), Vec3::Ones());
  budgets.add(0, 10, window.dem, window.fluid);
  window.dem.particles = 9;
  window.dem.mass_kg = 4.5;
  window.fluid.solid_volume_m3 = 1.8;
  window.fluid.particle_pressure[2] = 100;
  window.fluid.particle_pressure_abs = 100;
  window.fluid.cell_pressure[2] = 99;
  budgets.add(0.1, 10, window.dem, window.fluid);
  EXPECT_EQ(budgets.particles_lost(), 1);
  EXPECT_EQ(column(budgets, "mass_lost_kg"), 0.5);
  EXPECT_NEAR(budgets.solid_volume_defect(), 0.1, 1e-15);
  EXPECT_NEAR(budgets.pressure_defect(), 0.01, 1e-15);
}

TEST(Budgets, OutstandingForgetsAfterTenWindows) {
  Case window;
  Budgets budgets(Models(), Vec3::Ones());
  window.dem.received_abs = 1e6;
  budgets.add(0.1, 10, window.dem, window.fluid);
  window.dem.received_abs = 2;
  for (int n = 0; n < 10; ++n) {
    budgets.add(0.1, 10, window.dem, window.fluid);
  }
  EXPECT_NEAR(budgets.momentum_outstanding(), 1 / (10 * (2 + 5.0)), 1e-15);
}

TEST(Budgets, NothingExchangedIsNoDefect) {
  Budgets budgets(Models(), Vec3::Ones());
  budgets.add(0.1, 10, DemSums(), FluidSums());
  EXPECT_EQ(budgets.momentum_defect(), 0);
  EXPECT_EQ(budgets.momentum_outstanding(), 0);
  EXPECT_EQ(budgets.solid_volume_defect(), 0);
  FluidSums ghost;
  ghost.solid_volume_m3 = 1e-9;  // solid without particles
  budgets.add(0.1, 10, DemSums(), ghost);
  EXPECT_EQ(budgets.solid_volume_defect(), 1);
}
