// Spheres in LIGGGHTS' own files.
#pragma once

#include <string>
#include <vector>

#include "spheres.hpp"

namespace slidewave::pack {

/// Outer box of the particle engine [m].
struct Bounds {
  double low[3];
  double high[3];
};

/// Writes a data file for `atom_style granular` (id type diameter density x y z); all spheres are
/// of type 1, `types` is the number of types that the script declares.
void write_data(std::string const& path, std::vector<Sphere> const& spheres, Bounds const& bounds,
                double density_kg_m3, int types);

/// Reads the last snapshot of a `dump custom` with at least the columns x y z radius.
std::vector<Sphere> read_dump(std::string const& path);

}  // namespace slidewave::pack
