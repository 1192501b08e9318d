// Drag from lattice-Boltzmann of fixed arrays, Hill, Koch & Ladd 2001 (J. Fluid Mech. 448), as used
// in CFD-DEM. phi = 1 - eps, Re of the superficial slip and the diameter (hence the 0.5):
//
//   K = 3 pi mu d eps^2 (F0 + 0.5 F3 Re),   F3 = 0.0673 + 0.212 phi + 0.0232/eps^5
//   F0 = N/(1 + 0.681 phi - 8.48 phi^2 + 8.16 phi^3)                 for phi < 0.4
//   N  = 1 + 3 sqrt(phi/2) + 135/64 phi ln phi + 16.14 phi
//   F0 = 10 phi/eps^3                                                above
//
// The two F0 differ by 1 % at phi = 0.4: blended over 0.38 to 0.42.
#pragma once

#include <algorithm>
#include <cmath>

#include "slidewave/physics/grain.hpp"

namespace slidewave {

struct KochHill {
  static constexpr char const* name = "koch_hill";
  /// K [kg/s] of one grain, formulation A.
  static double drag(Grain const& grain) {
    double const eps = grain.void_fraction;
    double const cube = eps * eps * eps;
    double const phi = std::max(1 - eps, 1e-30);
    double const t = std::clamp((phi - 0.38) / 0.04, 0.0, 1.0);
    double const dense = t * t * (3 - 2 * t);
    double const f0 = dense * (10 * phi / cube) + (1 - dense) * dilute(std::min(phi, 0.42));
    double const f3 = 0.0673 + 0.212 * phi + 0.0232 / (cube * eps * eps);
    return 3 * M_PI * grain.viscosity_Pa_s * grain.diameter_m * eps * eps *
           (f0 + 0.5 * f3 * grain.reynolds());
  }

 private:
  static double dilute(double phi) {
    return (1 + 3 * std::sqrt(phi / 2) + 135.0 / 64 * phi * std::log(phi) + 16.14 * phi) /
           (1 + phi * (0.681 + phi * (-8.48 + phi * 8.16)));
  }
};

}  // namespace slidewave
