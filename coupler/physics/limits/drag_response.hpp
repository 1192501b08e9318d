// How stiff the drag is: response time m/K of a particle against a step or a window.
//
//   x = K W/m                 of a particle in fluid that does not move
//   x (1 + loading)           of the slip in a mixture whose fluid moves too,
//                             loading = solid mass/fluid mass = phi rho_s/(eps rho_f)
//
// The exponential kick is exact for any x with the fluid frozen. The mild regime's window coupling
// is meant for x < 0.3; prototypes that fall, jam and are lifted again stayed right up to 0.15 at a
// solid fraction of 0.6 and blew up at 0.3 (at 0.3: fraction 0.3 still right). The rate of a free
// suspension is right for x (1 + loading) < 0.2. Source of all limits: docs/stability.md.
#pragma once

#include <algorithm>

namespace slidewave::limits {

constexpr double mild_stiffness = 0.3;
constexpr double dense_mild_stiffness = 0.15;  ///< at solid fractions above dense_solid_fraction
constexpr double dense_solid_fraction = 0.45;
constexpr double accurate_mixture_stiffness = 0.2;
/// The stiff regime, with both engines: settling, suspensions and frozen beds stayed right to here;
/// beds held by contacts were tried to 1e7; suspensions ended in lost particles at 8e9.
constexpr double largest_stiffness = 1e9;
/// From here on it also damps contact waves (and from mild_stiffness compression, up to
/// stiff_added_mass_number).
constexpr double damping_stiffness = 0.1;

/// The mild regime in a crowd that may settle, by continuity: x (phi/eps)^2. With both engines
/// right at 1.28 (phi 0.5), 1.24 (0.64), 1.36 (0.7), 0.8 (0.74: 7 % off, as in the stiff regime);
/// grown, or wrong by a third and more, at 1.83, 1.54, 1.63, 1.2. The same x caps dilute ones: a
/// free suspension was right within 4 % at 1.7 and 11 % off at 3.3.
inline double largest_mild_stiffness(double solid_fraction) {
  double const pushed = solid_fraction / (1 - solid_fraction);
  return 1 / std::max(1.0, pushed * pushed);
}
/// The same where every particle is held: right at 1.6, wrong by a factor of five at 3.2.
constexpr double largest_held_mild_stiffness = 1.5;

/// m/K [s].
inline double response_time(double mass_kg, double drag_kg_s) {
  return mass_kg / drag_kg_s;
}

/// K W/m of a time W.
inline double stiffness(double drag_kg_s, double time_s, double mass_kg) {
  return drag_kg_s * time_s / mass_kg;
}

/// Solid mass over fluid mass of a mixture.
inline double loading(double solid_fraction, double solid_density, double fluid_density) {
  return solid_fraction * solid_density / ((1 - solid_fraction) * fluid_density);
}

/// Stiffness of the slip in a mixture: x (1 + loading).
inline double mixture_stiffness(double stiffness_x, double mass_loading) {
  return stiffness_x * (1 + mass_loading);
}

}  // namespace slidewave::limits
