// Which physics the case switches on, and hence what must be exchanged.
#pragma once

#include <string>
#include <vector>

#include "slidewave/engine.hpp"
#include "slidewave/physics/drag_models.hpp"
#include "slidewave/scene.hpp"

namespace slidewave {

enum class Outside { error, warn, ignore };

/// A field that a model wants from the fluid engine.
struct Need {
  Field field;
  std::string model;
};

struct Models {
  bool drag = true;
  DragModel drag_model;
  bool pressure_gradient = true;
  bool two_way = true;
  bool stiff = false;             ///< drag right for any K W/m; the mild form costs less
  bool concurrent = false;        ///< both sides advance at once; else the fluid goes first
  double coarse_grain = 1;        ///< alpha: particle diameter over grain diameter
  double smoothing_length_m = 0;  ///< kernel length, two-way only
  Outside outside = Outside::error;

  static Models from(Scene const& scene);
  /// One side alone: nothing is exchanged.
  static Models none();
  /// Porosity: the fluid sees the particles' volume.
  bool porosity() const { return two_way; }
  /// Momentum goes both ways, so what is given and not received must be kept.
  bool ledger() const { return two_way && drag; }
  /// What a particle engine must gather beyond what every scene needs.
  std::vector<Need> particle_needs() const;
  std::vector<Need> needs() const;
  std::vector<Feature> features() const;
};

}  // namespace slidewave
