// Drag coefficient of a single sphere, Brown & Lawler 2003 (J. Environ. Eng. 129):
//   Cd = 24/Re (1 + 0.150 Re^0.681) + 0.407/(1 + 8710/Re)        fitted for Re < 2e5
// Given as Cd Re, finite at rest (24: Stokes). Beyond the fit it stays near 0.46: no drag crisis.
#pragma once

#include <cmath>

namespace slidewave {

struct BrownLawler {
  static constexpr char const* name = "brown_lawler";
  /// Cd Re at Reynolds number Re >= 0.
  static double cd_re(double re) {
    return 24 * (1 + 0.150 * std::pow(re, 0.681)) + 0.407 * re * re / (re + 8710);
  }
};

}  // namespace slidewave
