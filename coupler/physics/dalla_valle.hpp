// Drag coefficient of a single sphere, DallaValle 1948: Cd = (0.63 + 4.8/sqrt(Re))^2, Di Felice's
// partner. Given as Cd Re, finite at rest: 23.04 there, 4 % below Stokes (PHYSICS.md 0.3).
#pragma once

#include <cmath>

namespace slidewave {

struct DallaValle {
  static constexpr char const* name = "dalla_valle";
  static double cd_re(double re) {
    double const root = 0.63 * std::sqrt(re) + 4.8;
    return root * root;
  }
};

}  // namespace slidewave
