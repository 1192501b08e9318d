// Drag coefficient of a creeping sphere, Stokes 1851: Cd = 24/Re. Given as Cd Re.
#pragma once

namespace slidewave {

struct Stokes {
  static constexpr char const* name = "stokes";
  static double cd_re(double re) { return 0 * re + 24; }
};

}  // namespace slidewave
