// The negotiated records: what one particle costs on the wire, in both directions.
#pragma once

#include <string>
#include <vector>

#include "models.hpp"

namespace slidewave {

struct Layout {
  std::vector<Field> to_fluid;
  std::vector<Field> to_dem;

  static Layout of(Models const& models);
  /// The columns of the particle engine's tables.
  static std::vector<Field> gathered(Models const& models, bool has_partner);
  static std::vector<Field> answered(Models const& models);
  std::string text() const;
};

int doubles_per_particle(std::vector<Field> const& fields);

/// What the coupler keeps in the fourth component of `memory`: the fluid rank that owned the
/// particle and its cell there, exact in a double. 0: unknown.
struct HomeCode {
  int owner = -1;
  int cell = -1;
  static HomeCode decode(double code);
  double encode() const;
};

}  // namespace slidewave
