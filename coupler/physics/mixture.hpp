// Properties of two fluids at a particle from the saturation a, the first fluid's share of the pore
// space. Values outside 0 to 1 (round-off of an advected field) count as the nearer end.
#pragma once

#include <algorithm>

namespace slidewave {

/// a x_1 + (1 - a) x_2: density, and by default viscosity.
inline double mixture(double saturation, double first, double second) {
  double const a = std::clamp(saturation, 0.0, 1.0);
  return a * first + (1 - a) * second;
}

/// 1/(a/mu_1 + (1 - a)/mu_2): viscosity of layers in series, the lower bound.
inline double harmonic_mixture(double saturation, double first, double second) {
  double const a = std::clamp(saturation, 0.0, 1.0);
  return 1 / (a / first + (1 - a) / second);
}

}  // namespace slidewave
