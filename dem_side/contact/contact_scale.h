// Coarse-grain scaling of the contact constants that scripts give (physics/clump.hpp): chosen once
// a run, before the script is read.
#pragma once

#include "model_settings.h"
#include "rolling_laws.h"
#include "slidewave/physics/clump.hpp"

namespace slidewave::dem {

/// Of this process; factors 1 until the engine sets them.
inline ContactScale& contact_scale() {
  static ContactScale scale;
  return scale;
}

/// From the constant of a grain, as given, to that of a particle.
inline void scale_stiffness(double& k) {
  if (k != not_given) {
    k *= contact_scale().stiffness;
  }
}
inline void scale_rotation(double& k) {
  if (k != not_given) {
    k *= contact_scale().rotation;
  }
}

}  // namespace slidewave::dem
