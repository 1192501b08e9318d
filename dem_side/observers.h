// Columns of history.csv that the particles contribute, asked for in case.toml:
//
//   [observe.slide]  type = "slide"            the whole mass: slide_speed_m_s (mass-weighted
//   mean),
//       slide_front_x_m (99 % of the mass lies at smaller x), kinetic_energy_J (translation and
//       rotation), max_overlap (pairs, over the smaller diameter), particles
//   [observe.NAME]   type = "particle"  id = 1   NAME_x_m ... NAME_vz_m_s of one particle
#pragma once

#include <string>
#include <vector>

#include "slidewave/engine.hpp"
#include "slidewave/scene.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::dem {

class Observers {
 public:
  /// Takes the tables of observe.* that are of a type above. Throws InputError for a particle that
  /// does not exist. Collective.
  Observers(LAMMPS_NS::LAMMPS& lmp, Scene const& scene);
  /// Values now, the same on all ranks. Collective.
  std::vector<Quantity> observe() const;

 private:
  struct Particle {
    std::string name;
    int id = 0;
  };

  LAMMPS_NS::LAMMPS& lmp_;
  bool slide_ = false;
  std::vector<Particle> particles_;
};

/// x below which `part` of the mass lies [m], to a millionth of the extent. Collective.
double mass_front_x(LAMMPS_NS::LAMMPS& lmp, double part);

/// Largest overlap of a pair over the smaller diameter of the two [-], from the neighbour list of
/// the last step; 0 before the first. Collective.
double max_overlap(LAMMPS_NS::LAMMPS& lmp);

/// Translational and rotational kinetic energy of all particles [J]. Collective.
double kinetic_energy(LAMMPS_NS::LAMMPS& lmp);

}  // namespace slidewave::dem
