// The added-mass number of a confined suspension: by continuity a moving particle pushes r =
// phi/eps of fluid the other way, and the inertia of that comes back through the pressure gradient
// a window late. S = rho_f r/rho_s; with virtual mass, C rho_f V of inertia beside each particle's
// own,
//
//   S = rho_f ((1 + 2 C) r + C r^2)/(rho_s + C rho_f):
//
// rho_f r of the fluid, C rho_f r of what the fluid's acceleration does to the particle, and
// C rho_f r (1 + r) of the reaction on the fluid, which the pressure hands on. In formulation B no
// pressure is handed on and C r is left. A lag multiplies by S a window. Source: PHYSICS.md 0.10,
// 4.4, DESIGN.md 4; docs/theory.md.
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
                                double virtual_mass_coefficient = 0, bool shares_pressure = true) {
  double const r = solid_fraction / (1 - solid_fraction), c = virtual_mass_coefficient;
  double const pushed = shares_pressure ? (1 + 2 * c) * r + c * r * r : c * r;
  return fluid_density * pushed / (solid_density + c * fluid_density);
}

}  // namespace slidewave::limits
