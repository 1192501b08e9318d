// Drag in a packed bed, Ergun 1952 (Chem. Eng. Prog. 48):
//   dp/L = 150 mu (1-eps)^2 U/(eps^3 d^2) + 1.75 rho (1-eps) U^2/(eps^3 d),  U superficial
// As a force per grain in formulation A (bed: eps dp/L = n K (u - v)), Re superficial:
//   K = pi/6 d mu (150 (1-eps) + 1.75 Re)/eps.  Not for dilute flow: K -> 0 at rest for eps -> 1.
#pragma once

#include <cmath>

#include "slidewave/physics/grain.hpp"

namespace slidewave {

struct Ergun {
  static constexpr char const* name = "ergun";
  /// K [kg/s] of one grain, formulation A.
  static double drag(Grain const& grain) {
    double const eps = grain.void_fraction;
    return M_PI / 6 * grain.diameter_m * grain.viscosity_Pa_s *
           (150 * (1 - eps) + 1.75 * grain.reynolds()) / eps;
  }
};

}  // namespace slidewave
