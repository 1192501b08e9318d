// How cells, particles and the smoothing kernel must stand to each other (DESIGN.md 5).
#pragma once

#include <algorithm>

namespace slidewave::limits {

/// Cells from a tenth of the diameter (right within 0.2 % there, docs/stability.md; the kernel, not
/// the cell, makes the void fraction) to five diameters.
constexpr double smallest_cell_per_diameter = 0.1;
constexpr double largest_cell_per_diameter = 5;

/// Edge of a cube of the cell's volume, or of a square of its area where the mesh is one cell
/// thick, is what `cell_m` means.
inline double cell_per_diameter(double cell_m, double diameter_m) {
  return cell_m / diameter_m;
}

/// Shortest smoothing length [m] with a smooth void fraction: 1.5 D_max and 1.5 cells.
inline double smoothing_length(double largest_diameter_m, double cell_m) {
  return 1.5 * std::max(largest_diameter_m, cell_m);
}

/// Below this share of it a lone sphere's speed was 11 % off, at it 2 % (docs/stability.md).
constexpr double shortest_smoothing_share = 0.4;

/// Narrowest periodic direction [m]. Packaged contact laws: two diameters, or pairs that touch
/// through both images share one contact history and the whole mass drifts. Laws that tell images
/// apart (model linear): just over one, or a particle touches its own image.
inline double periodic_width(double largest_diameter_m, bool images_told_apart = false) {
  return (images_told_apart ? 1.001 : 2) * largest_diameter_m;
}

}  // namespace slidewave::limits
