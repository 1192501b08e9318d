// Facts of a small scene against brute force.
#include <gtest/gtest.h>

#include "held_atoms.h"
#include "small_scene.h"
#include "stock_facts.h"

namespace {

TEST(Facts, LargestOverlapIsOverTheSmallerDiameter) {
  SmallScene scene;
  scene.box("f f f");
  EXPECT_EQ(slidewave::dem::max_overlap(scene.lmp()), 0);
  scene.contacts(1e6, 1e6, 0.5);
  scene.sphere(4.9, 5, 5, 0.4);
  scene.sphere(5.15, 5, 5, 0.2);  // across the border of two ranks: 0.05 of 0.2
  scene.sphere(5, 8, 5, 0.4);
  scene.sphere(5, 8.39, 5, 0.4);  // 0.01 of 0.4
  scene.lines({"fix integrate all nve/sphere", "run 0"});
  double largest = slidewave::dem::max_overlap(scene.lmp());
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  EXPECT_NEAR(largest, 0.25, 1e-12);
}

TEST(Facts, AreThoseOfTheScript) {
  SmallScene scene;
  scene.box("f p f");
  EXPECT_EQ(slidewave::dem::boundaries(scene.lmp()), "bpb");
  EXPECT_EQ(slidewave::dem::gravity(scene.lmp())->norm(), 0);
  scene.lines({"variable up equal step", "fix weight all gravity 5 vector 3 0 -4"});
  EXPECT_EQ(slidewave::dem::as_text(*slidewave::dem::gravity(scene.lmp())), "3 0 -4");
  scene.lines({"fix more all gravity v_up vector 0 0 1"});
  EXPECT_FALSE(slidewave::dem::gravity(scene.lmp()));
}

TEST(Facts, PartlyHeldAxesAreThoseOfAtomsFreeAlongAnother) {
  SmallScene scene;
  scene.box("f f f");
  scene.sphere(2, 5, 5, 0.4);
  scene.sphere(8, 5, 5, 0.4);
  auto const axes = [&] {
    slidewave::dem::HeldAtoms atoms;
    atoms.find(scene.lmp());
    return atoms.partly_held(scene.lmp());
  };
  EXPECT_EQ(axes(), "");  // integrated by nobody: held wholly
  scene.lines({"fix integrate all nve/sphere"});
  EXPECT_EQ(axes(), "");
  scene.lines({"region right block 6 10 0 10 0 10 units box", "group right region right",
               "fix slab right setforce 0 NULL 0"});
  EXPECT_EQ(axes(), "xz");
  scene.lines({"fix frozen right setforce 0 0 0"});
  EXPECT_EQ(axes(), "");
}

TEST(Facts, PositionsWrapIntoThePeriodicBox) {
  SmallScene scene;
  scene.box("f p f");
  double const outside[3] = {-1, 23.5, 11};
  slidewave::Vec3 const inside = slidewave::dem::wrapped(scene.lmp(), outside);
  EXPECT_EQ(inside, slidewave::Vec3(-1, 3.5, 11));
  double const barely[3] = {0, -1e-30, 0};
  double const y = slidewave::dem::wrapped(scene.lmp(), barely)[1];
  EXPECT_TRUE(y >= 0 && y < 10);
}

}  // namespace
