#include <gtest/gtest.h>

#include "handshake.hpp"

using namespace slidewave;

TEST(Layout, CarriesOnlyWhatModelsWant) {
  Models models;
  EXPECT_EQ(doubles_per_particle(Layout::of(models).to_fluid), 11);
  EXPECT_EQ(doubles_per_particle(Layout::of(models).to_dem), 11);
  models.two_way = false;
  EXPECT_EQ(doubles_per_particle(Layout::of(models).to_fluid), 8);
  models.drag = false;
  EXPECT_EQ(doubles_per_particle(Layout::of(models).to_fluid), 5);
  EXPECT_EQ(doubles_per_particle(Layout::of(models).to_dem), 4);
  EXPECT_NE(Layout::of(models).text().find("to fluid 40 B"), std::string::npos);
}

TEST(Layout, EachForceAddsItsOwnColumns) {
  Models const plain;
  auto const added = [&](Models const& models) {
    return doubles_per_particle(Layout::of(models).to_dem) -
           doubles_per_particle(Layout::of(plain).to_dem);
  };
  Models models;
  models.virtual_mass = VirtualMass::constant;
  EXPECT_EQ(added(models), 4);  // mass, and its force, which the budget counts
  models.lift = true;
  EXPECT_EQ(added(models), 4);
  models.torque = true;
  EXPECT_EQ(added(models), 8);
  models.two_way = models.torque = false;
  Models one_way;
  one_way.two_way = false;
  EXPECT_EQ(doubles_per_particle(Layout::of(models).to_dem),
            doubles_per_particle(Layout::of(one_way).to_dem) + 1);
  EXPECT_EQ(Layout::of(models).to_fluid.size(), Layout::of(one_way).to_fluid.size());
}

TEST(HomeCode, RoundTripsExactly) {
  for (int owner : {0, 1, 2097150}) {
    for (int cell : {-1, 0, 1, 2147483646}) {
      HomeCode const read = HomeCode::decode(HomeCode{owner, cell}.encode());
      EXPECT_EQ(read.owner, owner);
      EXPECT_EQ(read.cell, cell);
    }
  }
  EXPECT_EQ(HomeCode::decode(0).owner, -1);
  EXPECT_EQ(HomeCode::decode(0).cell, -1);
}

TEST(Needs, AnErrorNamesTheModel) {
  Models models;
  models.two_way = false;
  std::vector<Field> offers = {
      {"velocity", "m/s", 3}, {"density", "kg/m3", 1}, {"pressure_gradient", "Pa/m", 3}};
  try {
    check_needs(models, offers);
    FAIL();
  } catch (std::runtime_error const& error) {
    EXPECT_NE(std::string(error.what()).find("'drag' needs the field 'viscosity'"),
              std::string::npos);
  }
  offers.push_back({"viscosity", "m2/s", 1});
  EXPECT_THROW(check_needs(models, offers), std::runtime_error);  // of another unit
  offers.back().unit = "Pa s";
  EXPECT_NO_THROW(check_needs(models, offers));
}
