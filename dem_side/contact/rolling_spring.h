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

/// Moment on the first body; `theta` (3 numbers) is changed only if `advance`. Returns the energy
/// [J] lost by yielding in this step.
inline double rolling_moment(RotationSpring const& spring, double* theta, double const* normal,
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
  double lost = 0;
  for (int k = 0; k < 3; ++k) {
    double const held = now[k] * kept;
    lost += (theta[k] + held) * (now[k] - held);
    out[k] = -spring.k * held;
    if (advance) {
      theta[k] = held;
    }
  }
  return advance ? 0.5 * spring.k * lost : 0.0;
}

/// Moment along the normal, on the first body; the lost energy [J] is added to `lost`.
inline double twisting_moment(RotationSpring const& spring, double* theta, double omega_normal,
                              double dt_s, bool advance, double& lost) {
  double const now = *theta + (advance ? omega_normal * dt_s : 0.0);
  double const moment = spring.k * std::abs(now);
  double const held = now * (moment > spring.limit ? spring.limit / moment : 1.0);
  if (advance) {
    lost += 0.5 * spring.k * (*theta + held) * (now - held);
    *theta = held;
  }
  return -spring.k * held;
}

}  // namespace slidewave::dem
