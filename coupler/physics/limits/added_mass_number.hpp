// The added-mass number of a confined suspension, S = rho_f (C + phi/eps)/rho_s: by continuity a
// moving particle pushes phi/eps of fluid the other way, and its inertia comes back through the
// pressure gradient a window late. C is the virtual-mass coefficient where that force is lagged; 0
// where it is inertia (always, here). Source: PHYSICS.md 0.10, 4.4, DESIGN.md 4.
#pragma once

namespace slidewave::limits {

/// With both engines (docs/stability.md) closed columns that settle stayed right to 5 at K W/m =
/// 0.1 and blew up at 7.5, touching piles stayed right to 2.3, all that were tried.
constexpr double mild_added_mass_number = 3.0;
/// Stiff regime, from damping_stiffness on: right at 1.5, blown up at 1.67 (K W/m 0.4, 1, 10).
constexpr double stiff_added_mass_number = 1.5;
constexpr double comfortable_stiff_added_mass_number = 1.0;
constexpr double comfortable_added_mass_number = 0.6;  ///< rock in water at 0.6

inline double added_mass_number(double solid_fraction, double solid_density, double fluid_density,
                                double lagged_coefficient = 0) {
  return fluid_density * (lagged_coefficient + solid_fraction / (1 - solid_fraction)) /
         solid_density;
}

}  // namespace slidewave::limits
