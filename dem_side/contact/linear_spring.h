// Normal contact law: a linear spring, with a dashpot if wanted.
//
//   F = kn delta - gamma v_n,  gamma = 2 zeta sqrt(kn m_eff)   (v_n > 0: surfaces part)
//
// Restitution of a free pair: e = exp(-pi zeta/sqrt(1 - zeta^2)); contact time pi sqrt(m_eff/kn) at
// zeta = 0. Without `attraction` the force never pulls, as no dry contact does; with it the closed
// forms above hold to the end of the contact. Units: kn [N/m], delta [m], v_n [m/s], m_eff [kg].
#pragma once

#include <algorithm>
#include <cmath>

namespace slidewave::dem {

struct LinearSpring {
  double kn = 0;
  double zeta = 0;
  bool attraction = false;

  double force(double overlap_m, double parting_speed, double m_eff) const {
    double const elastic = kn * overlap_m;
    if (zeta == 0) {
      return elastic;
    }
    double const total = elastic - 2 * zeta * std::sqrt(kn * m_eff) * parting_speed;
    return attraction ? total : std::max(total, 0.0);
  }
};

}  // namespace slidewave::dem
