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

namespace slidewave::dem {

struct CoulombSlider {
  double ks = 0;
  double mu = 0;
  double zeta = 0;

  /// Gives the force on the first body; `s` (3 numbers) is changed only if `advance`. Returns the
  /// energy [J] lost in this step, by sliding (mean of the force before and after, times the slip)
  /// and in the dashpot; 0 unless `advance`.
  double force(double* s, double const* normal, double const* v_t, double dt_s,
               double normal_force_N, double m_eff, bool advance, double* out) const {
    double now[3] = {s[0], s[1], s[2]};
    if (advance) {
      for (int k = 0; k < 3; ++k) {
        now[k] += v_t[k] * dt_s;
      }
      double const off = now[0] * normal[0] + now[1] * normal[1] + now[2] * normal[2];
      for (int k = 0; k < 3; ++k) {
        now[k] -= off * normal[k];
      }
    }
    double const square = now[0] * now[0] + now[1] * now[1] + now[2] * now[2];
    double const limit_N = mu * std::abs(normal_force_N);
    double lost_J = 0;
    if (ks * ks * square > limit_N * limit_N) {
      double const kept = limit_N / (ks * std::sqrt(square));
      double along = 0;
      for (int k = 0; k < 3; ++k) {
        double const held = now[k] * kept;
        along += (s[k] + held) * (now[k] - held);
        now[k] = held;
        out[k] = -ks * held;
      }
      lost_J = 0.5 * ks * along;
    } else {
      double const gamma = zeta == 0 ? 0.0 : 2 * zeta * std::sqrt(ks * m_eff);
      for (int k = 0; k < 3; ++k) {
        out[k] = -ks * now[k] - gamma * v_t[k];
      }
      if (zeta != 0) {
        lost_J = gamma * dt_s * (v_t[0] * v_t[0] + v_t[1] * v_t[1] + v_t[2] * v_t[2]);
      }
    }
    if (!advance) {
      return 0.0;
    }
    for (int k = 0; k < 3; ++k) {
      s[k] = now[k];
    }
    return lost_J;
  }
};

}  // namespace slidewave::dem
