// History by particle and periodic image (VAJONT.md): in a periodic box thinner than two diameters
// a pair can touch through both faces. The packaged law keeps one history for both contacts and the
// mass drifts along the thin direction; ours does not, down to just over one diameter.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "domain.h"
#include "pair_style.h"
#include "small_scene.h"

namespace {

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.17g", value);
  return buffer;
}

// A box thin along y, with walls at x = 0, z = 0 and x = 10 m that have no friction: nothing from
// outside acts along y.
struct Slab : SmallScene {
  Slab(double width_m, std::string const& contacts) {
    lines({"units si", "atom_style granular", "atom_modify map array", "boundary f p f",
           "newton off", "communicate single vel yes", "processors * 1 1",
           "region box block 0 10 0 " + text(width_m) + " 0 10 units box", "create_box 1 box",
           "neighbor 0.1 bin", "neigh_modify delay 0"});
    if (contacts == "packaged") {
      this->contacts(1e7, 8e6, 0.5);
    } else {
      law(contacts);
    }
    std::string const smooth =
        contacts == "packaged" ? "model hooke/stiffness" : "model linear kn 1e7";
    wall("floor", smooth, "primitive type 1 zplane 0");
    wall("left", smooth, "primitive type 1 xplane 0");
    wall("right", smooth, "primitive type 1 xplane 10");
  }
};

std::string const own = "model linear kn 1e7 tangential coulomb ks 8e6 mu 0.5";

// Speed along y of the centre of mass of 64 spheres of 0.9 to 1 m that slump in the slab, after
// `steps`.
double drift(double width_m, std::string const& contacts, int steps) {
  Slab scene(width_m, contacts);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  int const spheres = 64;
  for (int n = 0; n < spheres; ++n) {
    scene.sphere(0.6 + 1.1 * (n % 8) + 0.05 * any(random), width_m * any(random),
                 0.55 + 1.05 * (n / 8), 0.9 + 0.1 * any(random));
  }
  scene.lines({"fix integrate all nve/sphere", "fix weight all gravity 9.81 vector 0.3 0 -1",
               "timestep 4e-4", "run " + std::to_string(steps)});
  double momentum = 0;
  double mass_kg = 0;
  double fastest = 0;
  for (int n = 1; n <= spheres; ++n) {
    momentum += scene.mass(n) * scene.v(n, 1);
    mass_kg += scene.mass(n);
    fastest = std::max(fastest, std::abs(scene.v(n, 1)));
  }
  EXPECT_GT(fastest, 0.01) << "the scene must move along y";
  return std::abs(momentum / mass_kg);
}

// The momentum along y stays zero unless contacts break action and reaction.
TEST(Images, PackagedLawDriftsAndOursDoesNot) {
  double const packaged = drift(1.1, "packaged", 8000);
  double const ours = drift(1.1, own, 8000);
  EXPECT_GT(packaged, 0.05);
  EXPECT_LT(ours, 1e-10);
}

// Two equal spheres in a slab of 1.3 diameters, touching through both faces, sheared along x: each
// contact keeps its own spring, and both springs are equal by symmetry. The same as two contacts
// with two separate particles held by the same motion.
TEST(Images, BothContactsOfAPairKeepTheirOwnSpring) {
  double const width_m = 1.9;  // centres half a width apart: both gaps are 0.95 m, spheres 1 m
  Slab scene(width_m, own);
  scene.sphere(5, 0.3, 5, 1.0);
  scene.sphere(5, 0.3 + width_m / 2, 5, 1.0);
  scene.set_velocity(1, "0.01 0 0");
  scene.set_velocity(2, "-0.01 0 0");
  scene.lines({"fix integrate all nve/sphere", "timestep 1e-5", "run 100"});
  auto const* const pairs = slidewave::dem::OwnPairs::current();
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  double const slip_m = 0.02 * 100 * 1e-5;
  double sums[2] = {pairs->elastic().normal, pairs->elastic().tangential};
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_NEAR(sums[0], 2 * 0.5 * 1e7 * 0.05 * 0.05, 1e-3 * sums[0]);
  EXPECT_NEAR(sums[1], 2 * 0.5 * 8e6 * slip_m * slip_m, 0.02 * sums[1]);
  // By symmetry neither sphere is pushed along y.
  EXPECT_NEAR(scene.v(1, 1), 0, 1e-12);
  EXPECT_NEAR(scene.v(2, 1), 0, 1e-12);
}

// A rebuild of the neighbour lists, and a pass through the periodic face, must not lose or swap
// springs: the same pair carried along y through the face, against one that stays.
TEST(Images, SpringsSurviveRebuildsAndTheFace) {
  double end[2][6];
  for (int carried = 0; carried < 2; ++carried) {
    Slab scene(1.9, own);
    scene.sphere(4.98, 0.3, 5, 1.0);
    scene.sphere(5.02, 0.3 + 0.95, 5.01, 1.0);
    double const speed = carried ? 20.0 : 0.0;
    scene.set_velocity(1, "0.05 " + text(speed) + " 0.02");
    scene.set_velocity(2, "-0.05 " + text(speed) + " 0");
    scene.set_spin(1, 0.3, 0.1, 0.2);
    scene.lines({"fix integrate all nve/sphere", "timestep 1e-4", "run 2000"});
    for (int axis = 0; axis < 3; ++axis) {
      end[carried][axis] = scene.v(1, axis) - (axis == 1 ? speed : 0);
      end[carried][axis + 3] = scene.omega(1, axis);
    }
  }
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(end[1][k], end[0][k], 1e-8) << k;
  }
}

TEST(Images, SlabOfLittleMoreThanOneDiameter) {
  EXPECT_LT(drift(1.01, own, 4000), 1e-10);
}

}  // namespace
