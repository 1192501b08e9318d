// Courant numbers and what follows from them.
#pragma once

#include <limits>

namespace slidewave::limits {

constexpr double largest_courant = 0.5;             ///< of the flow (PHYSICS.md 4.7: 0.25 to 0.5)
constexpr double largest_interface_courant = 0.25;  ///< at a free surface
/// Of a cell that a particle, or the void fraction with it, may cross in a window (4.3).
constexpr double largest_crossing = 0.3;

/// u dt/dx; u interstitial.
inline double courant(double speed_m_s, double dt_s, double cell_m) {
  return speed_m_s * dt_s / cell_m;
}

/// The largest step [s] for a Courant number; infinite at rest.
inline double courant_step(double limit, double speed_m_s, double cell_m) {
  return speed_m_s > 0 ? limit * cell_m / speed_m_s : std::numeric_limits<double>::infinity();
}

}  // namespace slidewave::limits
