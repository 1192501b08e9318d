#include <gtest/gtest.h>

#include "models.hpp"
#include "scratch.hpp"

using namespace slidewave;

namespace {

Models read(std::string const& text) {
  Scratch const scratch(text);
  return Models::from(Scene(scratch.path));
}

}  // namespace

TEST(Models, DefaultsAreTheFlagships) {
  Models const models = read("[coupling]\nsmoothing_length = 5.7\n");
  EXPECT_TRUE(models.drag && models.pressure_gradient && models.two_way && models.ledger());
  EXPECT_EQ(models.drag_model.law, "di_felice");
  EXPECT_EQ(models.coarse_grain, 1);
  EXPECT_EQ(models.smoothing_length_m, 5.7);
  EXPECT_EQ(models.outside, Outside::error);
}

TEST(Models, OneWayNeedsNoKernelNorLedger) {
  Models const models = read("[coupling]\nreaction = \"one_way\"\n");
  EXPECT_FALSE(models.porosity());
  EXPECT_FALSE(models.ledger());
  for (Need const& need : models.needs()) {
    EXPECT_NE(need.field.name, "void_fraction");
    EXPECT_NE(need.field.name, "mean_velocity");
  }
}

TEST(Models, RefusesWhatItDoesNotKnow) {
  std::string const one_way = "[coupling]\nreaction = \"one_way\"\n";
  EXPECT_THROW(read("[coupling]\nreaction = \"both\"\n"), InputError);
  EXPECT_THROW(read(one_way + "outside = \"lose\"\n"), InputError);
  EXPECT_THROW(read(one_way + "scheme = \"sereal\"\n"), InputError);
  EXPECT_THROW(read(one_way + "[models]\ndrag = 3\n"), InputError);
  EXPECT_THROW(read(one_way + "[models]\nformulation = \"C\"\n"), InputError);
  EXPECT_THROW(read(one_way + "[parameters]\ncoarse_grain = -1\n"), InputError);
  EXPECT_THROW(read("[coupling]\nreaction = \"two_way\"\n"), InputError);  // no smoothing length
}

TEST(Models, AlphaByTypeWantsTheType) {
  std::string const two_way = "[coupling]\nsmoothing_length = 1.0\n";
  std::string const list = "[models]\ncoarse_grain_by_type = [1, 2.5]\n";
  Models const models = read(two_way + list);
  ASSERT_EQ(models.particle_needs().size(), 1u);
  EXPECT_EQ(models.particle_needs()[0].field.name, "type");
  EXPECT_FALSE(
      read(two_way + list + "drag = \"none\"\n").by_type());  // volume forces need no grains
  EXPECT_THROW(read(two_way + "[models]\ncoarse_grain_by_type = [1, 0]\n"), InputError);
  EXPECT_THROW(read(two_way + "[models]\ncoarse_grain_by_type = []\n"), InputError);
  EXPECT_THROW(read(two_way + list + "contact_scaling = \"sakai\"\n"), InputError);
  EXPECT_THROW(read(two_way + list + "[parameters]\ncoarse_grain = 2\n"), InputError);
}

TEST(Models, StiffRegimeAsksForMoreAndOnlyThere) {
  std::string const two_way = "[coupling]\nsmoothing_length = 1.0\n";
  EXPECT_TRUE(read(two_way).particle_needs().empty());
  Models const stiff = read(two_way + "regime = \"stiff\"\n");
  EXPECT_TRUE(stiff.stiff);
  EXPECT_EQ(stiff.particle_needs().size(), 3u);
  EXPECT_EQ(stiff.needs().size(), read(two_way).needs().size() + 1);
  // Without a reaction the kick is exact at any stiffness.
  EXPECT_FALSE(read("[coupling]\nreaction = \"one_way\"\nregime = \"stiff\"\n").stiff);
  EXPECT_THROW(read(two_way + "regime = \"hard\"\n"), InputError);
  EXPECT_THROW(read(two_way + "regime = \"stiff\"\n[models]\npressure_gradient = false\n"),
               InputError);
}

TEST(Models, ConcurrentIsMildAndNeedsNoMeanVelocity) {
  std::string const two_way = "[coupling]\nsmoothing_length = 1.0\n";
  EXPECT_FALSE(read(two_way).concurrent);
  EXPECT_FALSE(read(two_way + "scheme = \"auto\"\n").concurrent);  // the command line chooses
  Models const models = read(two_way + "scheme = \"concurrent\"\n");
  EXPECT_TRUE(models.concurrent);
  EXPECT_EQ(models.needs().size(), read(two_way).needs().size() - 1);
  EXPECT_THROW(read(two_way + "scheme = \"concurrent\"\nregime = \"stiff\"\n"), InputError);
}

TEST(Models, AForceThatIsOffCostsNothing) {
  Models const models = read("[coupling]\nsmoothing_length = 1.0\n");
  EXPECT_TRUE(models.answer_needs().empty());
  EXPECT_FALSE(models.exchanged_force());
  for (Need const& need : models.needs()) {
    for (char const* field : {"acceleration", "vorticity", "viscous_stress"}) {
      EXPECT_NE(need.field.name, field);
    }
  }
}

TEST(Models, EachForceAsksForItsOwn) {
  std::string const start = "[coupling]\nsmoothing_length = 1.0\n[models]\n";
  auto const wants = [&](std::string const& model, std::string const& field) {
    bool found = false;
    Models const models = read(start + model);
    for (auto const& needs : {models.needs(), models.answer_needs()}) {
      for (Need const& need : needs) {
        found = found || need.field.name == field;
      }
    }
    return found;
  };
  EXPECT_TRUE(wants("virtual_mass = \"zuber\"\n", "acceleration"));
  EXPECT_TRUE(wants("virtual_mass = \"constant\"\n", "added_mass"));
  EXPECT_TRUE(wants("virtual_mass = \"constant\"\n", "exchanged_force"));
  EXPECT_TRUE(wants("lift = \"saffman_mei\"\n", "vorticity"));
  EXPECT_FALSE(wants("lift = \"saffman_mei\"\n", "added_mass"));
  EXPECT_TRUE(wants("torque = \"rotational_drag\"\n", "fluid_spin"));
  EXPECT_FALSE(wants("torque = \"rotational_drag\"\n", "exchanged_force"));
  EXPECT_TRUE(wants("viscous_force = true\n", "viscous_stress"));
}

TEST(Models, FormulationBTakesNoShareOfTheStress) {
  std::string const start = "[coupling]\nsmoothing_length = 1.0\n";
  std::string const b = "[models]\nformulation = \"B\"\n";
  Models const models = read(start + b);
  EXPECT_TRUE(models.archimedes() && models.force() && !models.pressure_gradient);
  EXPECT_EQ(models.drag_model.formulation, Formulation::B);
  for (Need const& need : models.needs()) {
    EXPECT_NE(need.field.name, "pressure_gradient");
  }
  EXPECT_THROW(read(start + b + "pressure_gradient = true\n"), InputError);
  EXPECT_THROW(read(start + b + "viscous_force = true\n"), InputError);
  EXPECT_THROW(read(start + "scheme = \"concurrent\"\n" + b), InputError);
  EXPECT_NO_THROW(read("[coupling]\nreaction = \"one_way\"\nscheme = \"concurrent\"\n" + b));
}

TEST(Models, StiffRegimeRefusesForcesThatItCannotForesee) {
  std::string const stiff = "[coupling]\nsmoothing_length = 1.0\nregime = \"stiff\"\n";
  EXPECT_THROW(read(stiff + "[models]\nformulation = \"B\"\n"), InputError);
  EXPECT_THROW(read(stiff + "[models]\nvirtual_mass = \"constant\"\n"), InputError);
  EXPECT_THROW(read(stiff + "[models]\nlift = \"saffman_mei\"\n"), InputError);
  EXPECT_TRUE(read(stiff + "[models]\ntorque = \"rotational_drag\"\n").stiff);
}

TEST(Models, NoneIsNothing) {
  EXPECT_TRUE(Models::none().needs().empty());
  EXPECT_FALSE(Models::none().porosity());
}
