// Drag of a lone sphere, no voidage function: f = pi/8 d^2 rho Cd |u - v| (u - v).
// For dilute scenes and reference runs. K with f = K (u - v):  K = pi/8 d mu (Cd Re).
#pragma once

#include <cmath>

#include "slidewave/physics/grain.hpp"

namespace slidewave {

template <class Coefficient>
struct SingleSphere {
  static constexpr char const* name = "single_sphere";
  static double drag(Grain const& grain) {
    double const re = grain.reynolds() / grain.void_fraction;  // of the interstitial slip
    return M_PI / 8 * grain.diameter_m * grain.viscosity_Pa_s * Coefficient::cd_re(re);
  }
};

}  // namespace slidewave
