// Compression waves of the touching particles against the window.
//
// In the serial coupling the fluid learns how particles moved a window late, so their added mass
// (S = rho_f phi/(rho_s eps)) acts late too. A wave of frequency w is then damped for w W < 1.5 and
// fed with energy between about 1.8 and 5, contact damping or not. Waves shorter than the smoothing
// kernel do not reach the fluid, so what counts is how far the skeleton's wave runs in a window:
// c W/L, c = d sqrt(kn/m). Columns of 64 spheres with L from 1.5 to 6 d and cells from 1 to 4 d
// grew above 1.2 (S = 1.5), 1.2 to 2 (S = 0.57), 1.6 to 3 (S = 0.15) and not in air (S < 0.01).
// Undamped piles of spheres with both engines (docs/stability.md), S by the fluid's density: still
// right at 1.9 (S = 1.05), 1.5 (1.37), 0.8 (2.31); grown at 3 (1.05) and 1.1 (2.31). So at most 2,
// and 2/S where S > 1.
#pragma once

#include <algorithm>
#include <cmath>

namespace slidewave::limits {

/// c W/L at most, for an added-mass number.
inline double largest_wave_run(double added_mass_number) {
  return 2 / std::max(1.0, added_mass_number);
}
/// Share of it that a run should keep to.
constexpr double comfortable_wave_share = 0.6;
/// Below this added-mass number the fluid is too light to feed the waves.
constexpr double feeding_added_mass_number = 0.1;

/// Speed [m/s] of compression waves in touching spheres of this diameter and mass.
inline double skeleton_wave_speed(double diameter_m, double mass_kg, double kn_N_m) {
  return diameter_m * std::sqrt(kn_N_m / mass_kg);
}

/// c W/L.
inline double wave_run(double wave_speed_m_s, double window_s, double smoothing_length_m) {
  return wave_speed_m_s * window_s / smoothing_length_m;
}

}  // namespace slidewave::limits
