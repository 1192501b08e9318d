// Rolling and twisting resistance: an elastic-plastic spring of relative rotation.
//
//   theta <- theta + omega dt;  M = -k theta;  |M| <= limit, theta shortened to limit/k on yield
//
// `omega` is the relative angular velocity of the bodies, its part in the contact plane (rolling,
// 3 numbers) or along the normal (twisting, 1 number). Units: k [N m/rad], limit [N m].
#pragma once

#include <cmath>

namespace slidewave::dem {

/// Stiffness and limit moment of one contact.
struct RotationSpring {
  double k = 0;
  double limit = 0;
};

/// Moment on the first body; `theta` (3 numbers) is changed only if `advance`.
inline void rolling_moment(RotationSpring const& spring, double* theta, double const* normal,
                           double const* omega, double dt_s, bool advance, double* out) {
  double now[3] = {theta[0], theta[1], theta[2]};
  if (advance) {
    for (int k = 0; k < 3; ++k) {
      now[k] += omega[k] * dt_s;
    }
    double const twist = now[0] * normal[0] + now[1] * normal[1] + now[2] * normal[2];
    for (int k = 0; k < 3; ++k) {
      now[k] -= twist * normal[k];
    }
  }
  double const moment = spring.k * std::sqrt(now[0] * now[0] + now[1] * now[1] + now[2] * now[2]);
  double const kept = moment > spring.limit ? spring.limit / moment : 1.0;
  for (int k = 0; k < 3; ++k) {
    now[k] *= kept;
    out[k] = -spring.k * now[k];
    if (advance) {
      theta[k] = now[k];
    }
  }
}

/// Moment along the normal, on the first body.
inline double twisting_moment(RotationSpring const& spring, double* theta, double omega_normal,
                              double dt_s, bool advance) {
  double now = *theta + (advance ? omega_normal * dt_s : 0.0);
  double const moment = spring.k * std::abs(now);
  now *= moment > spring.limit ? spring.limit / moment : 1.0;
  if (advance) {
    *theta = now;
  }
  return -spring.k * now;
}

}  // namespace slidewave::dem
