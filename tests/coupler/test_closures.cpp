#include <gtest/gtest.h>

#include "closures.hpp"

using namespace slidewave;

namespace {

Table one_particle(double radius, double slip, double void_fraction) {
  Table table;
  for (char const* name : {"velocity", "fluid_velocity", "force"}) {
    table.add({name, "", 3});
  }
  for (char const* name : {"density", "viscosity", "radius", "void_fraction", "drag"}) {
    table.add({name, "", 1});
  }
  table.resize(1);
  table["fluid_velocity"](0, 0) = slip;
  table["density"](0, 0) = 1000;
  table["viscosity"](0, 0) = 1e-3;
  table["radius"](0, 0) = radius;
  table["void_fraction"](0, 0) = void_fraction;
  table["force"].col(0) = Vec3(0, 0, -9810);  // grad p, before the force is made of it
  return table;
}

double drag(Table table, Models const& models) {
  evaluate_drag(models, table);
  return table["drag"](0, 0);
}

Models di_felice() {
  Models models;
  models.drag_model = drag_model("di_felice", "brown_lawler", "A");
  return models;
}

}  // namespace

TEST(Closures, StokesAtRest) {
  EXPECT_NEAR(drag(one_particle(0.001, 0, 1), di_felice()), 6 * M_PI * 1e-3 * 0.001, 1e-15);
}

TEST(Closures, DiFeliceByHand) {
  // d = 2 mm, slip 0.1 m/s, eps 0.5: Re = 100, chi = 3.7 - 0.65 exp(-(1.5 - 2)^2/2)
  double const chi = 3.7 - 0.65 * std::exp(-0.125);
  double const cd = 24 / 100. * (1 + 0.15 * std::pow(100, 0.681)) + 0.407 / (1 + 8710 / 100.);
  double const force = M_PI / 8 * 4e-6 * 1000 * cd * 0.01 * std::pow(0.5, 2 - chi);
  EXPECT_NEAR(drag(one_particle(0.001, 0.1, 0.5), di_felice()) * 0.1, force, 1e-12 * force);
}

TEST(Closures, OneWayTakesNoVoidFraction) {
  Models models = di_felice();
  models.two_way = false;
  EXPECT_EQ(drag(one_particle(0.001, 0.1, 0.5), models),
            drag(one_particle(0.001, 0.1, 1.0), di_felice()));
}

TEST(Closures, ClumpIsManyGrains) {
  Models models = di_felice();
  double const grain = drag(one_particle(0.001, 0.1, 0.6), models);
  models.coarse_grain = 10;
  EXPECT_NEAR(drag(one_particle(0.01, 0.1, 0.6), models), 1000 * grain, 1e-10 * grain);
}

TEST(Closures, BuoyancyIsTheWeightOfTheFluid) {
  Table table = one_particle(0.1, 0, 1);
  evaluate_force(table);
  EXPECT_NEAR(table["force"](2, 0), 9810 * 4 * M_PI / 3 * 1e-3, 1e-10);
  EXPECT_EQ(table["force"](0, 0), 0);
}
