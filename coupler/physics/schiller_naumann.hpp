// Drag coefficient of a single sphere, Schiller & Naumann 1933, with Newton's plateau:
//   Cd = max(24/Re (1 + 0.15 Re^0.687), 0.44)
// Given as Cd Re, finite at rest. The maximum instead of a switch at Re = 1000 keeps it continuous
// (the two differ between Re 990 and 1000 only).
#pragma once

#include <algorithm>
#include <cmath>

namespace slidewave {

struct SchillerNaumann {
  static constexpr char const* name = "schiller_naumann";
  static double cd_re(double re) {
    return std::max(24 * (1 + 0.15 * std::pow(re, 0.687)), 0.44 * re);
  }
};

}  // namespace slidewave
