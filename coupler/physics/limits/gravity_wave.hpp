// A free surface whose weight acts with the level of the step's start is stable while the shortest
// gravity wave that the mesh holds, w = sqrt(pi g/dx) (deep water, wavelength two cells), does not
// turn too far in a step: a leap of w dt = 2 is the limit of any explicit oscillator. A sloshing
// tank with both fluids (docs/stability.md) ran at 1.5 and ended in infinities at 1.9.
#pragma once

#include <cmath>

namespace slidewave::limits {

constexpr double comfortable_wave_turn = 1.0;
constexpr double largest_wave_turn = 1.6;

/// w of the shortest wave [1/s].
inline double shortest_wave_rate(double gravity_m_s2, double cell_m) {
  return std::sqrt(M_PI * gravity_m_s2 / cell_m);
}

}  // namespace slidewave::limits
