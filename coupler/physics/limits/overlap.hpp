// Overlap of linear contacts, as a fraction of the diameter.
#pragma once

#include <cmath>

namespace slidewave::limits {

/// Above this the geometry is no longer that of touching spheres (VAJONT.md: kn 3e8, overlap 26 %
/// is too soft; 3 to 6 % made no difference).
constexpr double largest_overlap = 0.1;
constexpr double comfortable_overlap = 0.05;
/// Where a run ends unless dem.overlap_limit says otherwise: spheres lie a third inside each other.
constexpr double unbearable_overlap = 0.3;

/// At the foot of a column: stress/(kn/D) with stress = bulk density g h (PHYSICS.md 1.6).
inline double static_overlap(double height_m, double bulk_density_kg_m3, double gravity_m_s2,
                             double diameter_m, double kn_N_m) {
  return bulk_density_kg_m3 * gravity_m_s2 * height_m * diameter_m / kn_N_m;
}

/// Of two equal spheres that meet at `speed_m_s`: v sqrt(m/(2 kn))/D (PHYSICS.md D1).
inline double impact_overlap(double speed_m_s, double mass_kg, double diameter_m, double kn_N_m) {
  return speed_m_s * std::sqrt(mass_kg / (2 * kn_N_m)) / diameter_m;
}

/// The stiffness [N/m] that brings an overlap to `wanted`: it goes with 1/kn in a column and with
/// 1/sqrt(kn) in an impact.
inline double stiffness_for_static(double overlap, double wanted, double kn_N_m) {
  return kn_N_m * overlap / wanted;
}
inline double stiffness_for_impact(double overlap, double wanted, double kn_N_m) {
  return kn_N_m * (overlap / wanted) * (overlap / wanted);
}

}  // namespace slidewave::limits
