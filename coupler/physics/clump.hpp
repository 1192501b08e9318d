// Coarse graining: a particle of diameter D = alpha d stands for alpha^3 grains of diameter d that
// move together. Closures are evaluated at d and summed over the grains; volume forces (weight,
// pressure gradient) see the particle's own volume and need nothing. Source: PHYSICS.md 0.5, 1.6.
#pragma once

namespace slidewave {

/// Diameter of the grains [m] in a particle of diameter D.
inline double grain_diameter(double diameter_m, double alpha) {
  return diameter_m / alpha;
}

/// How many grains a particle stands for: the factor from one grain's force, or K, to the clump's.
inline double grains_per_particle(double alpha) {
  return alpha * alpha * alpha;
}

}  // namespace slidewave
