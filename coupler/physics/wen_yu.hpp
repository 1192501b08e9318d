// Drag in a suspension, Wen & Yu 1966 (Chem. Eng. Prog. Symp. Ser. 62): Schiller-Naumann at the
// superficial Reynolds number, times eps^-2.65. Per volume (formulation A)
//   beta = 3/4 Cd rho |u - v| (1-eps) eps eps^-2.65/d;   per grain  K = pi/8 d mu (Cd Re)
//   eps^-2.65.
#pragma once

#include <cmath>

#include "slidewave/physics/grain.hpp"
#include "slidewave/physics/schiller_naumann.hpp"

namespace slidewave {

struct WenYu {
  static constexpr char const* name = "wen_yu";
  /// K [kg/s] of one grain, formulation A.
  static double drag(Grain const& grain) {
    double const swarm = 1 / std::pow(grain.void_fraction, 2.65);
    return M_PI / 8 * grain.diameter_m * grain.viscosity_Pa_s *
           SchillerNaumann::cd_re(grain.reynolds()) * swarm;
  }
};

}  // namespace slidewave
