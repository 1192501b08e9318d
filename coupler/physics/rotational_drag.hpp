// Torque of a viscous fluid on a rotating sphere, Kirchhoff 1876 (creeping rotation):
//   T = pi mu d^3 (curl u/2 - w_p)
// Linear in w_p, so the exponential kick takes it too: pass rotational_drag() as K, the moment of
// inertia as mass, curl u/2 as fluid velocity. Of one grain: times alpha^3 for a clump.
#pragma once

#include <cmath>

namespace slidewave {

/// pi mu d^3 [N m s].
inline double rotational_drag(double diameter_m, double viscosity_Pa_s) {
  return M_PI * viscosity_Pa_s * diameter_m * diameter_m * diameter_m;
}

}  // namespace slidewave
