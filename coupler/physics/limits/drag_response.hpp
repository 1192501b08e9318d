// How stiff the drag is: response time m/K of a particle against a step or a window.
//
//   x = K W/m                 of a particle in fluid that does not move
//   x (1 + loading)           of the slip in a mixture whose fluid moves too,
//                             loading = solid mass/fluid mass = phi rho_s/(eps rho_f)
//
// The exponential kick is exact for any x with the fluid frozen. The mild regime's window coupling
// is for x < 0.3; columns of spheres that fall, jam and are lifted
// again stayed right up to 0.15 at a solid fraction of 0.6 and blew up at 0.3 (at 0.3: fraction 0.3
// still right). The rate of a free suspension is right for x (1 + loading) < 0.2.
#pragma once

namespace slidewave::limits {

constexpr double mild_stiffness = 0.3;
constexpr double dense_mild_stiffness = 0.15;  ///< at solid fractions above dense_solid_fraction
constexpr double dense_solid_fraction = 0.45;
constexpr double accurate_mixture_stiffness = 0.2;
/// The stiff regime (docs/stability.md): suspensions, settling and held beds stayed right to here
/// with both engines, settling and suspensions also to 1e7; beyond, momentum is lost to round-off.
constexpr double largest_stiffness = 1e6;
/// From here on it also damps contact waves (and from mild_stiffness compression, up to
/// stiff_added_mass_number).
constexpr double damping_stiffness = 0.1;

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
