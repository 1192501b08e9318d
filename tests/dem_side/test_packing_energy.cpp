// 2,000 undamped frictional spheres at rest under their weight: nothing may feed them energy.
// Quick: 5,000 steps. SLIDEWAVE_SLOW: a million (label full).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>

#include "energy_audit.h"
#include "small_scene.h"

namespace {

using slidewave::dem::EnergyAudit;

TEST(Packing, KeepsItsEnergyAtRest) {
  bool const slow = std::getenv("SLIDEWAVE_SLOW") != nullptr;
  SmallScene scene;
  scene.lines({"units si", "atom_style granular", "atom_modify map array", "boundary p p f",
               "newton off", "communicate single vel yes", "processors * 1 1",
               "region box block 0 10 0 10 -1 40 units box", "create_box 1 box", "neighbor 0.2 bin",
               "neigh_modify delay 0"});
  std::string const law = "model linear kn 2e8 tangential coulomb ks 1.6e8 mu 0.5";
  scene.law(law + " damping 0.5");
  scene.wall("floor", law + " damping 0.5", "primitive type 1 zplane 0");
  // A face-centred lattice, loose, of 2,000 spheres; sizes vary by the atom's id.
  scene.lines({"lattice fcc 1.5", "region fill block 0 9.9 0 9.9 0.6 17.4 units box",
               "create_atoms 1 region fill", "set group all diameter 1 density 2650"});
  LAMMPS_NS::Atom& atom = *scene.lmp().atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    std::mt19937 random(static_cast<unsigned>(atom.tag[i]));
    std::uniform_real_distribution<double> any(0, 1);
    double const diameter = 0.8 + 0.2 * any(random);
    atom.radius[i] = diameter / 2;
    atom.rmass[i] = 2650 * std::acos(-1.0) / 6 * std::pow(diameter, 3);
    for (int axis = 0; axis < 2; ++axis) {
      atom.v[i][axis] = any(random) - 0.5;
    }
  }
  scene.lines({"fix integrate all nve/sphere", "fix weight all gravity 9.81 vector 0 0 -1",
               "timestep 3e-4", "fix slow all viscous 500", "run 14000", "unfix slow",
               "unfix floor"});
  // Without dashpots from here on; the springs begin anew, and drag takes what that sets free.
  scene.law(law);
  scene.wall("floor", law, "primitive type 1 zplane 0");
  scene.lines({"fix slow all viscous 3000", "run 5000", "unfix slow"});
  EnergyAudit audit(scene.lmp(), false);
  scene.lines({"run 0"});
  audit.observe();
  std::map<std::string, double> start;
  std::map<std::string, double> end;
  for (slidewave::Quantity const& one : audit.observe()) {
    start[one.name] = one.value;
  }
  scene.lines({"run " + std::to_string(slow ? std::atol(std::getenv("SLIDEWAVE_SLOW")) : 5000)});
  for (slidewave::Quantity const& one : audit.observe()) {
    end[one.name] = one.value;
  }
  std::printf("%d spheres, kinetic %.3g J, springs %.6g J, heat %.3g J, drift %.3g\n", atom.nlocal,
              end["energy_translation_J"], end["energy_normal_J"], end["heat_friction_J"],
              end["energy_drift"]);
  EXPECT_LT(std::abs(end["energy_drift"]), 1e-3);
  EXPECT_LT(end["energy_translation_J"],
            2 * start["energy_translation_J"] + 1e-3 * end["energy_normal_J"]);
  EXPECT_NEAR(end["energy_normal_J"], start["energy_normal_J"], 0.02 * start["energy_normal_J"]);
}

}  // namespace
