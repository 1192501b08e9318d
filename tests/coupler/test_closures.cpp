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
  evaluate_drag(models, RowRange::all(table), table);
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

TEST(Closures, AlphaByType) {
  Models models = di_felice();
  models.coarse_grain_by_type = {1, 10, 4};
  Models one = di_felice();
  for (double const type : {1.0, 2.0, 3.0}) {
    Table table = one_particle(0.01, 0.1, 0.6);
    table.add({"type", "-", 1});
    table["type"](0, 0) = type;
    one.coarse_grain = models.coarse_grain_by_type[static_cast<std::size_t>(type) - 1];
    evaluate_drag(models, RowRange::all(table), table);
    EXPECT_EQ(table["drag"](0, 0), drag(one_particle(0.01, 0.1, 0.6), one)) << type;
  }
}

TEST(Closures, BuoyancyIsTheWeightOfTheFluid) {
  Table table = one_particle(0.1, 0, 1);
  evaluate_force(di_felice(), Vec3(0, 0, -9.81), table);
  EXPECT_NEAR(table["force"](2, 0), 9810 * 4 * M_PI / 3 * 1e-3, 1e-10);
  EXPECT_EQ(table["force"](0, 0), 0);
}

TEST(Closures, ArchimedesIsTheSameAndComesInstead) {
  Table table = one_particle(0.1, 0, 1);
  Models models;
  models.formulation = Formulation::B;
  models.pressure_gradient = false;
  evaluate_force(models, Vec3(0, 0, -9.81), table);
  EXPECT_NEAR(table["force"](2, 0), 9810 * 4 * M_PI / 3 * 1e-3, 1e-10);
  table["force"].setConstant(1e6);  // a gradient that was not asked for
  evaluate_force(models, Vec3(0, 0, -9.81), table);
  EXPECT_EQ(table["force"](0, 0), 0);
}

TEST(Closures, ViscousStressAddsToPressure) {
  Table table = one_particle(0.1, 0, 1);
  table.add({"viscous_stress", "Pa/m", 3});
  table["viscous_stress"].col(0) = Vec3(7, 0, 0);
  Models models;
  models.viscous_force = true;
  evaluate_force(models, Vec3(0, 0, -9.81), table);
  double const volume = 4 * M_PI / 3 * 1e-3;
  EXPECT_NEAR(table["force"](0, 0), 7 * volume, 1e-12);
  EXPECT_NEAR(table["force"](2, 0), 9810 * volume, 1e-10);
}

TEST(Closures, VirtualMassByHand) {
  for (bool const two_way : {false, true}) {
    Table table = one_particle(0.1, 0, 0.6);
    table.add({"added_mass", "kg", 1});
    table.add({"acceleration", "m/s2", 3});
    table.add({"exchanged_force", "N", 3});
    table["acceleration"].col(0) = Vec3(2, 0, -1);
    Models models;
    models.two_way = two_way;
    models.virtual_mass = VirtualMass::zuber;
    table["force"].setConstant(5);
    evaluate_added_mass(models, RowRange::all(table), table);
    push(models, table);
    // Zuber at 0.6: C = 0.5 (1 + 0.8)/0.6 = 1.5; one-way no law sees a void fraction: 1/2.
    double const mass = (two_way ? 1.5 : 0.5) * 1000 * 4 * M_PI / 3 * 1e-3;
    EXPECT_NEAR(table["added_mass"](0, 0), mass, 1e-12);
    EXPECT_NEAR(table["exchanged_force"](0, 0), two_way ? 2 * mass : 0, 1e-12);
    EXPECT_NEAR(table["force"](0, 0), two_way ? 5 : 5 + 2 * mass, 1e-12);
    EXPECT_NEAR(table["force"](2, 0), two_way ? 5 : 5 - mass, 1e-12);
  }
}

TEST(Closures, LiftAndTorqueOfAClump) {
  Table table = one_particle(0.01, 0.02, 1);
  for (char const* name : {"vorticity", "lift", "fluid_spin"}) {
    table.add({name, "", 3});
  }
  table.add({"rotational_drag", "N m s", 1});
  table["vorticity"].col(0) = Vec3(0, 4, 0);
  table["viscosity"](0, 0) = 1;  // s^2 = nu w/U^2 = 10
  Models models;
  models.two_way = false;
  models.coarse_grain = 10;
  evaluate_lift(models, RowRange::all(table), table);
  evaluate_torque(models, table);
  // One grain, d = 2 mm: 1.615 d^2 rho sqrt(nu w) U J*, along x cross y, and pi mu d^3; 1000
  // grains.
  double const s = std::sqrt(10.0);
  double const factor =
      0.3 * (1 + std::tanh(2.5 * (std::log10(s) + 0.191))) * (0.667 + std::tanh(6 * (s - 0.32)));
  double const lift = 1000 * 1.615 * 4e-6 * 1000 * std::sqrt(4e-3) * 0.02 * factor;
  EXPECT_NEAR(table["lift"](2, 0), lift, 1e-10 * lift);
  EXPECT_EQ(table["lift"](0, 0), 0);
  EXPECT_NEAR(table["rotational_drag"](0, 0), 1000 * M_PI * 8e-9, 1e-18);
  EXPECT_EQ(table["fluid_spin"](1, 0), 2);
}

TEST(Closures, SomeRowsAtATimeAreAsAllAtOnce) {
  Models models = di_felice();
  models.coarse_grain_by_type = {1, 3};
  Table table = one_particle(0.1, 0, 0.6);
  table.add({"type", "-", 1});
  table.resize(5);
  for (long i = 0; i < 5; ++i) {
    table["type"](0, i) = 1 + i % 2;
    table["fluid_velocity"].col(i) = Vec3(0.1 * (1.0 + i), 0, 0);
    table["velocity"].col(i).setZero();
    table["density"](0, i) = 1000;
    table["viscosity"](0, i) = 1e-3;
    table["radius"](0, i) = 0.1 + 0.01 * i;
    table["void_fraction"](0, i) = 0.5 + 0.1 * i;
  }
  Table parts = table;
  evaluate_drag(models, RowRange::all(table), table);
  evaluate_drag(models, {0, 2}, parts);
  evaluate_drag(models, {2, 3}, parts);
  EXPECT_EQ(parts["drag"], table["drag"]);
  EXPECT_GT(table["drag"].row(0).minCoeff(), 0);
}
