// What a run needs, from unit costs on one 2020s core, meant to be right within a factor of two.
// The particle rate is measured (1.9 to 2.5 million particle-steps/s in a moving slide); the cell
// rate and the memory are estimates.
#pragma once

#include <cmath>

namespace slidewave::limits {

struct UnitCosts {
  double particle_steps_per_s = 2.0e6;
  double cell_steps_per_s = 1.5e5;
  double bytes_per_particle = 2000;  ///< both sides, contacts and neighbour lists included
  double bytes_per_cell = 2500;
  double bytes_per_rank = 8e7;  ///< libraries and MPI buffers
};

/// [bytes], all ranks together.
inline double memory_bytes(UnitCosts const& costs, double particles, double cells, double ranks) {
  return costs.bytes_per_particle * particles + costs.bytes_per_cell * cells +
         costs.bytes_per_rank * ranks;
}

/// [core s] of a number of steps.
inline double particle_seconds(UnitCosts const& costs, double particles, double steps) {
  return particles * steps / costs.particle_steps_per_s;
}
inline double cell_seconds(UnitCosts const& costs, double cells, double steps) {
  return cells * steps / costs.cell_steps_per_s;
}

}  // namespace slidewave::limits
