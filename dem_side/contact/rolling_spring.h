// Rolling and twisting resistance: an elastic-plastic spring of relative rotation.
//
//   theta <- theta + omega dt;  M = -k theta;  |M| <= limit, theta shortened to limit/k on yield
//
// `omega` is the relative angular velocity of the bodies, its part in the contact plane (rolling)
// or along the normal (twisting, 1 number). Units: k [N m/rad], limit [N m].
#pragma once

#include <cmath>

#include "vec4.h"

namespace slidewave::dem {

/// Stiffness and limit moment of one contact.
struct RotationSpring {
  double k = 0;
  double limit = 0;
};

/// Moment on the first body; `theta` is changed only if `advance`. Returns the energy [J] lost by
/// yielding in this step.
SLIDEWAVE_INLINE double rolling_moment(RotationSpring const& spring, Vec4& theta,
                                       Vec4 const& normal, Vec4 const& omega, double dt_s,
                                       bool advance, Vec4& out) {
  Vec4 now = theta;
  if (advance) {
    now += omega * dt_s;
    now -= dot(now, normal) * normal;
  }
  double const moment = spring.k * std::sqrt(dot(now, now));
  Vec4 const held = now * (moment > spring.limit ? spring.limit / moment : 1.0);
  out = -spring.k * held;
  if (!advance) {
    return 0.0;
  }
  double const lost = 0.5 * spring.k * dot(theta + held, now - held);
  theta = held;
  return lost;
}

/// Moment along the normal, on the first body; the lost energy [J] is added to `lost`.
SLIDEWAVE_INLINE double twisting_moment(RotationSpring const& spring, double& theta,
                                        double omega_normal, double dt_s, bool advance,
                                        double& lost) {
  double const now = theta + (advance ? omega_normal * dt_s : 0.0);
  double const moment = spring.k * std::abs(now);
  double const held = now * (moment > spring.limit ? spring.limit / moment : 1.0);
  if (advance) {
    lost += 0.5 * spring.k * (theta + held) * (now - held);
    theta = held;
  }
  return -spring.k * held;
}

}  // namespace slidewave::dem
