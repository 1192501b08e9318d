// Observers, facts and snapshots of a small scene against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "observers.h"
#include "small_scene.h"
#include "snapshot.h"
#include "stock_facts.h"

namespace {

namespace fs = std::filesystem;
using slidewave::dem::kinetic_energy;
using slidewave::dem::mass_front_x;
using slidewave::dem::max_overlap;

int rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

TEST(Observers, FrontHoldsTheGivenPartOfTheMass) {
  SmallScene scene;
  scene.box("f f f");
  for (int n = 0; n < 200; ++n) {
    scene.sphere(0.5 + 0.045 * n, 5, 5, 0.04);
  }
  EXPECT_NEAR(mass_front_x(scene.lmp(), 0.99), 0.5 + 0.045 * 197, 2e-5);
  EXPECT_NEAR(mass_front_x(scene.lmp(), 0.50), 0.5 + 0.045 * 99, 2e-5);
  EXPECT_NEAR(mass_front_x(scene.lmp(), 1.00), 0.5 + 0.045 * 199, 2e-5);
}

TEST(Observers, EmptySceneAndOneParticle) {
  SmallScene scene;
  scene.box("f f f");
  EXPECT_EQ(mass_front_x(scene.lmp(), 0.99), 0);
  EXPECT_EQ(kinetic_energy(scene.lmp()), 0);
  EXPECT_EQ(max_overlap(scene.lmp()), 0);
  scene.sphere(3, 5, 5, 0.1);
  EXPECT_EQ(mass_front_x(scene.lmp(), 0.99), 3);
  scene.lines({"velocity all set 3 0 4 units box"});
  EXPECT_NEAR(kinetic_energy(scene.lmp()), 0.5 * scene.mass(1) * 25, 1e-12);
}

TEST(Observers, LargestOverlapIsOverTheSmallerDiameter) {
  SmallScene scene;
  scene.box("f f f");
  scene.contacts(1e6, 1e6, 0.5);
  scene.sphere(4.9, 5, 5, 0.4);
  scene.sphere(5.15, 5, 5, 0.2);  // across the border of two ranks: 0.05 of 0.2
  scene.sphere(5, 8, 5, 0.4);
  scene.sphere(5, 8.39, 5, 0.4);  // 0.01 of 0.4
  scene.lines({"fix integrate all nve/sphere", "run 0"});
  EXPECT_NEAR(max_overlap(scene.lmp()), 0.25, 1e-12);
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

template <class T>
T big_endian(char const* from) {
  char bytes[sizeof(T)];
  std::reverse_copy(from, from + sizeof(T), bytes);
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

TEST(Snapshots, HoldEveryParticleSortedByIdWithItsLayer) {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  fs::path const folder = "snapshots_np" + std::to_string(ranks);
  if (rank() == 0) {
    fs::remove_all(folder);
    fs::create_directory(folder);
  }
  SmallScene scene;
  scene.box("f f f");
  int const count = 9;
  for (int n = 0; n < count; ++n) {
    scene.sphere(9.5 - n, 5, 1 + 0.5 * n, 0.2);
  }
  scene.lines({"velocity all set 1 2 -3 units box"});
  slidewave::dem::Snapshots snapshots(scene.lmp(), folder, 3);
  snapshots.write(0, 0);
  scene.lines(
      {"fix still all nve/noforce", "timestep 1e-9", "run 1"});  // a set-up keeps the layers
  snapshots.write(25, 0.5);
  MPI_Barrier(MPI_COMM_WORLD);
  std::ifstream series(folder / "particles.vtk.series");
  std::string const listed{std::istreambuf_iterator<char>(series), {}};
  EXPECT_NE(listed.find("{\"name\": \"particles_25.vtk\", \"time\": 0.5}"), std::string::npos);

  std::ifstream file(folder / "particles_25.vtk", std::ios::binary);
  std::string const vtk{std::istreambuf_iterator<char>(file), {}};
  auto const after = [&](std::string const& header) {
    std::size_t const at = vtk.find(header);
    EXPECT_NE(at, std::string::npos) << header;
    return vtk.data() + at + header.size();
  };
  char const* const points = after("POINTS 9 float\n");
  char const* const ids = after("SCALARS id int 1\nLOOKUP_TABLE default\n");
  char const* const radii = after("SCALARS radius float 1\nLOOKUP_TABLE default\n");
  char const* const layers = after("SCALARS layer int 1\nLOOKUP_TABLE default\n");
  char const* const velocities = after("VECTORS velocity float\n");
  for (int n = 0; n < count; ++n) {
    EXPECT_FLOAT_EQ(big_endian<float>(points + 12 * n), 9.5 - n);
    EXPECT_EQ(big_endian<std::int32_t>(ids + 4 * n), n + 1);
    EXPECT_FLOAT_EQ(big_endian<float>(radii + 4 * n), 0.1);
    EXPECT_EQ(big_endian<std::int32_t>(layers + 4 * n), std::min(n * 3 / 8, 2));
    EXPECT_FLOAT_EQ(big_endian<float>(velocities + 12 * n + 8), -3);
  }
}

}  // namespace
