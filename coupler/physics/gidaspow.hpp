// Gidaspow 1994: Ergun in dense beds, Wen-Yu in dilute flow, changing over at eps = 0.8, where the
// two do not meet. The smooth blend of Huilin & Gidaspow 2003 (Chem. Eng. Sci. 58) is used:
//   K = (1 - w) K_Ergun + w K_WenYu,   w = 1/2 + atan(150 * 1.75 (eps - 0.8))/pi
#pragma once

#include <cmath>

#include "slidewave/physics/ergun.hpp"
#include "slidewave/physics/wen_yu.hpp"

namespace slidewave {

struct Gidaspow {
  static constexpr char const* name = "gidaspow";
  /// K [kg/s] of one grain, formulation A.
  static double drag(Grain const& grain) {
    double const dilute = 0.5 + std::atan(150 * 1.75 * (grain.void_fraction - 0.8)) / M_PI;
    return (1 - dilute) * Ergun::drag(grain) + dilute * WenYu::drag(grain);
  }
};

}  // namespace slidewave
