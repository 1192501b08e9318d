// Speed at which a law's drag carries a grain's submerged weight, by bisection.
#pragma once

#include <cmath>

#include "slidewave/physics/grain.hpp"

namespace slidewave {

template <class Law>
double terminal_speed(Grain grain, double solid_density_kg_m3, double g_m_s2) {
  double const weight = M_PI / 6 * std::pow(grain.diameter_m, 3) *
                        (solid_density_kg_m3 - grain.density_kg_m3) * g_m_s2;
  double low = 0;
  double high = 1e3;
  for (int i = 0; i < 200; ++i) {
    grain.slip_m_s = 0.5 * (low + high);
    (Law::drag(grain) * grain.slip_m_s < weight ? low : high) = grain.slip_m_s;
  }
  return low;
}

}  // namespace slidewave
