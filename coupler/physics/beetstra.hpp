// Drag from lattice-Boltzmann, Beetstra, van der Hoef & Kuipers 2007 (AIChE J. 53), formulation A,
// phi = 1 - eps, Re of the superficial slip:  K = 3 pi mu d eps F,
//   F = 10 phi/eps^2 + eps^2 (1 + 1.5 sqrt(phi))
//     + 0.413 Re/(24 eps^2) (1/eps + 3 eps phi + 8.4 Re^-0.343)/(1 + 10^(3 phi) Re^(-(1+4 phi)/2))
// written below without negative powers of Re, so that it is finite at rest.
#pragma once

#include <algorithm>
#include <cmath>

#include "slidewave/physics/grain.hpp"

namespace slidewave {

struct Beetstra {
  static constexpr char const* name = "beetstra";
  /// K [kg/s] of one grain, formulation A.
  static double drag(Grain const& grain) {
    double const eps = grain.void_fraction;
    double const square = eps * eps;
    double const phi = std::max(1 - eps, 0.0);
    double const re = grain.reynolds();
    double const re_p = std::pow(re, 0.5 + 2 * phi);
    double const inertia = (re * (1 / eps + 3 * eps * phi) + 8.4 * std::pow(re, 0.657)) * re_p /
                           (re_p + std::exp(3 * M_LN10 * phi));
    return 3 * M_PI * grain.viscosity_Pa_s * grain.diameter_m * eps *
           (10 * phi / square + square * (1 + 1.5 * std::sqrt(phi)) +
            0.413 / 24 * inertia / square);
  }
};

}  // namespace slidewave
