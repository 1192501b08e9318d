// Tangential contact law (Cundall & Strack 1979): a spring in the contact plane with a Coulomb
// slider.
//
//   s <- s + v_t dt, turned into the contact plane;  F = -ks s - gamma v_t
//   |F| <= mu |F_n|; while it slides the spring is shortened to what it can hold.
//
// gamma = 2 zeta sqrt(ks m_eff). v_t is the relative velocity of the surfaces in the contact plane,
// spin included. Units: ks [N/m], s [m], forces [N].
#pragma once

#include <cmath>

#include "vec4.h"

namespace slidewave::dem {

struct CoulombSlider {
  double ks = 0;
  double mu = 0;
  double zeta = 0;

  /// Gives the force on the first body; `s` is changed only if `advance`. Returns the energy [J]
  /// lost in this step, by sliding (mean of the force before and after, times the slip) and in the
  /// dashpot; 0 unless `advance`.
  SLIDEWAVE_INLINE double force(Vec4& s, Vec4 const& normal, Vec4 const& v_t, double dt_s,
                                double normal_force_N, double m_eff, bool advance,
                                Vec4& out) const {
    Vec4 now = s;
    if (advance) {
      now += v_t * dt_s;
      now -= dot(now, normal) * normal;
    }
    double const square = dot(now, now);
    double const limit_N = mu * std::abs(normal_force_N);
    double lost_J = 0;
    if (ks * ks * square > limit_N * limit_N) {
      Vec4 const held = now * (limit_N / (ks * std::sqrt(square)));
      lost_J = 0.5 * ks * dot(s + held, now - held);
      now = held;
      out = -ks * held;
    } else {
      out = -ks * now;
      if (zeta != 0) {
        double const gamma = 2 * zeta * std::sqrt(ks * m_eff);
        out -= gamma * v_t;
        lost_J = gamma * dt_s * dot(v_t, v_t);
      }
    }
    if (!advance) {
      return 0.0;
    }
    s = now;
    return lost_J;
  }
};

}  // namespace slidewave::dem
