// Virtual (added) mass: F = C rho V (Du/Dt - dv/dt). The part -C rho V dv/dt is inertia: add
// added_mass() to the particle's mass, never lag it as a force. What is left as a force is
// added_mass() * Du/Dt. C = 1/2 for a lone sphere.
// Source: PHYSICS.md 1.4; dense suspensions Zuber 1964 (Chem. Eng. Sci. 19).
#pragma once

namespace slidewave {

/// C of a sphere at solid fraction 1 - eps (Zuber); 1/2 at eps = 1. The solid fraction is held at
/// 0.74, where the cell model that it comes from ends.
inline double added_mass_coefficient(double void_fraction) {
  double const phi = void_fraction < 0.26 ? 0.74 : 1 - void_fraction;
  return 0.5 * (1 + 2 * phi) / (1 - phi);
}

/// [kg] for a particle of this volume, coarse-grained or not (a volume law: no factor).
inline double added_mass(double coefficient, double fluid_density_kg_m3, double volume_m3) {
  return coefficient * fluid_density_kg_m3 * volume_m3;
}

}  // namespace slidewave
