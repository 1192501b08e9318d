// Which physics the case switches on, and hence what must be exchanged.
#pragma once

#include <string>
#include <vector>

#include "slidewave/engine.hpp"
#include "slidewave/physics/drag_models.hpp"
#include "slidewave/scene.hpp"

namespace slidewave {

enum class Outside { error, warn, ignore };

/// models.virtual_mass: the coefficient C of added_mass.hpp.
enum class VirtualMass { none, constant, zuber };

/// A field that a model wants from an engine, and the key that switches the model off.
struct Need {
  Field field;
  std::string model;
  std::string key;
};

struct Models {
  bool drag = true;
  DragModel drag_model;
  Formulation formulation = Formulation::A;
  bool pressure_gradient = true;  ///< A only
  bool viscous_force = false;     ///< A only
  bool lift = false;
  bool torque = false;
  VirtualMass virtual_mass = VirtualMass::none;
  bool two_way = true;
  bool stiff = false;       ///< drag right for any K W/m; the mild form costs less
  bool concurrent = false;  ///< both sides advance at once; else the fluid goes first
  double coarse_grain = 1;  ///< alpha: particle diameter over grain diameter
  std::vector<double> coarse_grain_by_type;  ///< the same by particle type from 1; empty: one alpha
  double smoothing_length_m = 0;             ///< kernel length, two-way only
  Outside outside = Outside::error;

  static Models from(Scene const& scene);
  /// One side alone: nothing is exchanged.
  static Models none();
  /// Porosity: the fluid sees the particles' volume.
  bool porosity() const { return two_way; }
  /// Closures at the grains' size want to know each particle's type.
  bool by_type() const { return !coarse_grain_by_type.empty() && (drag || lift || torque); }
  /// Alpha of a row of a table, which has the column type where by_type().
  double alpha(Table const& particles, long row) const {
    return by_type() ? coarse_grain_by_type[type_index(particles, row)] : coarse_grain;
  }
  bool moves_fluid_along() const { return virtual_mass != VirtualMass::none; }
  bool archimedes() const { return formulation == Formulation::B; }
  /// Momentum goes both ways, so what is given and not received must be kept.
  bool ledger() const { return two_way && (drag || lift || moves_fluid_along()); }
  /// Forces beside drag whose reaction stands in the fluid's momentum equation.
  bool exchanged_force() const { return two_way && (lift || moves_fluid_along()); }
  /// Forces on particles alone: shares of the fluid's stress, and one-way all others.
  bool force() const {
    return pressure_gradient || viscous_force || archimedes() ||
           (!two_way && (lift || moves_fluid_along()));
  }
  static std::size_t type_index(Table const& particles, long row) {
    return static_cast<std::size_t>(particles["type"](0, row)) - 1;
  }
  /// What a particle engine must gather beyond what every scene needs.
  std::vector<Need> particle_needs() const;
  /// What its apply() must take beyond that.
  std::vector<Need> answer_needs() const;
  std::vector<Need> needs() const;
  std::vector<Feature> features() const;
};

}  // namespace slidewave
