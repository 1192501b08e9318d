// How stiffly contacts hold a grain, measured from what they did over the last window: the secant
// |change of contact force| / |travel|. It must err high: half the true value lets a held bed and
// its fluid swing up, ten times it only makes a grain follow slowly (docs/stability.md has the
// runs).
#pragma once

#include <algorithm>
#include <cmath>

#include "slidewave/physics/window_response.hpp"

namespace slidewave {

/// Stiffness that an explicit step bears at most, 4 m/dt^2: above it velocity Verlet is unstable.
inline double stiffest_contact(double mass_kg, double dt_s) {
  return 4 * mass_kg / (dt_s * dt_s);
}

/// The estimate [N/m] for the coming window. `previous`: the last one, 0 at first; `change_N` and
/// `force_N`: magnitudes of the change of the contact force over the last window and of the force
/// now; `travel_m`: how far the grain went, 0 where that is round-off; `stiffest`: the bound, 0
/// where nothing is touched, or held_stiffness for a grain that forces do not move.
inline double contact_stiffness(double previous, double change_N, double force_N, double travel_m,
                                double stiffest) {
  constexpr double margin = 1.4;         // the secant of a mode is below its neighbours'
  constexpr double slowest_fall = 0.25;  // rises at once, falls by four in a window
  constexpr double least_change = 1e-3;  // of the force: below it a secant is round-off
  if (stiffest >= held_stiffness) {
    return held_stiffness;
  }
  if (stiffest == 0) {
    return 0;
  }
  if (travel_m == 0 && previous == 0) {
    return stiffest;  // touched from the start: no motion has told yet
  }
  if (travel_m == 0 || change_N < least_change * force_N) {
    return previous;
  }
  return std::min(stiffest, std::max(margin * change_N / travel_m, slowest_fall * previous));
}

}  // namespace slidewave
