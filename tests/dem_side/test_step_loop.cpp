// Windows of the coupled run against one uninterrupted LIGGGHTS run: the same to the last bit.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>

#include "small_scene.h"
#include "step_loop.h"
#include "update.h"

namespace {

constexpr int spheres = 60;

void pile(SmallScene& scene, std::string const& dump_file) {
  scene.box("p f f");
  scene.contacts(1e7, 8e6, 0.5);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.05, 0.05);
  for (int n = 0; n < spheres; ++n) {
    scene.sphere(1 + 0.9 * (n % 4) + jitter(random), 1 + 0.9 * (n / 4 % 3) + jitter(random),
                 0.6 + 0.9 * (n / 12) + jitter(random), 0.7 + jitter(random));
  }
  scene.lines(
      {"fix integrate all nve/sphere", "fix weight all gravity 9.81 vector 0.1 0 -1",
       "fix floor all wall/gran model hooke/stiffness tangential history primitive type 1 "
       "zplane 0",
       "fix back all wall/gran model hooke/stiffness tangential history primitive type 1 "
       "yplane 0.3",
       "fix front all wall/gran model hooke/stiffness tangential history primitive type 1 "
       "yplane 4",
       "fix fluid all slidewave drag 200 fluid_velocity 0.5 0 0.2 impulse",
       "dump states all custom 70 " + dump_file + " id x y z vx vy vz omegax fx",
       "dump_modify states sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"",
       "timestep 0.0005"});
}

std::string content(std::string const& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(StepLoop, WindowsAreOneRun) {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::string const stem = "step_loop_np" + std::to_string(ranks);
  double once[spheres][6];
  {
    SmallScene scene;
    pile(scene, stem + "_once.txt");
    scene.lines({"run 2100"});
    for (int n = 0; n < spheres; ++n) {
      for (int axis = 0; axis < 3; ++axis) {
        once[n][axis] = scene.x(n + 1, axis);
        once[n][axis + 3] = scene.omega(n + 1, axis);
      }
    }
  }
  SmallScene scene;
  pile(scene, stem + "_windows.txt");
  scene.lines({"run 0"});  // as a set-up script may do
  slidewave::dem::StepLoop loop(scene.lmp());
  for (int window = 0; window < 21; ++window) {
    loop.advance(0.05, 0.0005, 0.05 * (21 - window));
  }
  EXPECT_EQ(scene.lmp().update->ntimestep, 2100);
  for (int n = 0; n < spheres; ++n) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(scene.x(n + 1, axis), once[n][axis]) << n;
      EXPECT_EQ(scene.omega(n + 1, axis), once[n][axis + 3]) << n;
    }
  }
  loop.finish();
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(content(stem + "_windows.txt"), content(stem + "_once.txt"));
  EXPECT_GT(content(stem + "_once.txt").size(), 10000u);
}

TEST(StepLoop, StepsFillTheWindow) {
  using slidewave::dem::StepLoop;
  EXPECT_EQ(StepLoop::steps_in(0.02, 8e-4), 25);
  EXPECT_EQ(StepLoop::steps_in(0.02, 8.1e-4), 25);
  EXPECT_EQ(StepLoop::steps_in(0.02, 7.9e-4), 26);
  EXPECT_EQ(StepLoop::steps_in(0.02, 1.0), 1);
  EXPECT_EQ(StepLoop::steps_in(0.3, 0.1), 3);
}

TEST(StepLoop, AShorterLastWindowChangesTheStep) {
  SmallScene scene;
  scene.box("f f f");
  scene.sphere(5, 5, 9, 0.1);
  scene.lines({"fix integrate all nve/sphere", "fix weight all gravity 9.81 vector 0 0 -1"});
  slidewave::dem::StepLoop loop(scene.lmp());
  loop.advance(0.2, 0.01, 0.25);
  loop.advance(0.05, 0.008, 0.05);
  EXPECT_NEAR(loop.dt_s(), 0.05 / 7, 1e-15);
  EXPECT_NEAR(scene.v(1, 2), -9.81 * 0.25, 1e-12);
  EXPECT_NEAR(scene.x(1, 2), 9 - 0.5 * 9.81 * 0.25 * 0.25, 1e-12);
}

}  // namespace
