// Drag in a suspension, Di Felice 1994 (Int. J. Multiphase Flow 20): the single sphere's drag at
// the superficial slip U_s = eps |u - v|, times eps^-chi:
//   f_A = pi/8 d^2 rho Cd U_s^2 eps^-chi,   chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2)
// In the interstitial slip this is eps^(2 - chi), formulation A. The exponent 1 - chi that some
// papers print belongs to B; using it with a pressure-gradient force counts drag twice
// (PHYSICS.md 0.1). K with f = K (u - v):  K = pi/8 d mu (Cd Re) eps^(1 - chi).
#pragma once

#include <algorithm>
#include <cmath>

#include "slidewave/physics/grain.hpp"

namespace slidewave {

/// exp(-(1.5 - log10 Re)^2/2): a bump around Re = 31.6, zero at both ends.
inline double transition_bump(double reynolds) {
  double const distance = 1.5 - std::log10(std::max(reynolds, 1e-30));
  return std::exp(-0.5 * distance * distance);
}

/// chi from the superficial Reynolds number: 3.7 at both ends, 3.05 at Re = 31.6.
inline double di_felice_exponent(double reynolds) {
  return 3.7 - 0.65 * transition_bump(reynolds);
}

template <class Coefficient>
struct DiFelice {
  static constexpr char const* name = "di_felice";
  /// K [kg/s] of one grain, formulation A.
  static double drag(Grain const& grain) {
    double const re = grain.reynolds();
    double const voidage = std::pow(grain.void_fraction, 1 - di_felice_exponent(re));
    return M_PI / 8 * grain.diameter_m * grain.viscosity_Pa_s * Coefficient::cd_re(re) * voidage;
  }
};

}  // namespace slidewave
