// Explicit surface tension is stable below dt = sqrt((rho_1 + rho_2) dx^3/(4 pi sigma)), the time
// that the shortest capillary wave takes to cross a cell (Brackbill, Kothe & Zemach 1992).
#pragma once

#include <cmath>
#include <limits>

namespace slidewave::limits {

/// [s]; infinite without surface tension.
inline double capillary_step(double density_1, double density_2, double cell_m,
                             double tension_N_m) {
  return tension_N_m > 0 ? std::sqrt((density_1 + density_2) * cell_m * cell_m * cell_m /
                                     (4 * M_PI * tension_N_m))
                         : std::numeric_limits<double>::infinity();
}

}  // namespace slidewave::limits
