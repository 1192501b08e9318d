// Drag in a packed bed and suspension, Rong, Dong & Yu 2013 (Chem. Eng. Sci. 99;
// lattice-Boltzmann): Di Felice's form with
//   chi = 2.65 (eps + 1) - (5.3 - 3.5 eps) eps^2 exp(-(1.5 - log10 Re)^2/2)
// K with f_A = K (u - v):  K = pi/8 d mu (Cd Re) eps^(1 - chi), Re of the superficial slip.
#pragma once

#include <cmath>

#include "slidewave/physics/di_felice.hpp"

namespace slidewave {

template <class Coefficient>
struct Rong {
  static constexpr char const* name = "rong";
  /// K [kg/s] of one grain, formulation A.
  static double drag(Grain const& grain) {
    double const eps = grain.void_fraction;
    double const re = grain.reynolds();
    double const chi = 2.65 * (eps + 1) - (5.3 - 3.5 * eps) * eps * eps * transition_bump(re);
    return M_PI / 8 * grain.diameter_m * grain.viscosity_Pa_s * Coefficient::cd_re(re) *
           std::pow(eps, 1 - chi);
  }
};

}  // namespace slidewave
