// Largest time step of an explicit (velocity Verlet) integration of linear contacts.
//
// The fastest mode of a packing with z contacts a particle, each a normal spring kn and a
// tangential spring ks, is either neighbours moving against each other or all spheres spinning the
// same way (moment of inertia 2/5 m r^2):
//
//   w^2 = max( 2/3 z (kn + 2 ks), 10/3 z ks )/m,     critical step = 2/w
//
// exact for a simple cubic lattice (z = 6) and for a face-centred one without ks (8 kn/m); the
// test finds both by a sweep of lattice waves. With z = 12, ks = 0: 0.71 sqrt(m/kn); z = 5 and
// ks = 0.9 kn: 0.52 sqrt(m/kn), where a dry trial of Vajont still ran right (VAJONT.md).
#pragma once

#include <algorithm>
#include <cmath>

namespace slidewave::limits {

/// Contacts that the smallest particle of a loaded frictional packing has, near enough.
constexpr double usual_contact_number = 5;

/// [s]; `mass_kg` of the lightest particle, `contacts` the z above.
inline double critical_contact_step(double mass_kg, double kn_N_m, double ks_N_m,
                                    double contacts = usual_contact_number) {
  double const stiffness = contacts * std::max(2.0 / 3 * (kn_N_m + 2 * ks_N_m), 10.0 / 3 * ks_N_m);
  return 2 / std::sqrt(stiffness / mass_kg);
}

/// Duration [s] of a collision of two equal spheres: pi sqrt(m/(2 kn)) (PHYSICS.md D1).
inline double contact_time(double mass_kg, double kn_N_m) {
  return M_PI * std::sqrt(mass_kg / (2 * kn_N_m));
}

/// Share of the critical step that a run should keep to: 0.36 sqrt(m/kn) for ks = 0.9 kn.
constexpr double comfortable_step_fraction = 0.7;
/// Above this share dense lattices of spheres that do not slip, on a floor, gained energy: right at
/// 0.74, grown at 0.79 (docs/stability.md). Slipping spheres bear more.
constexpr double largest_step_fraction = 0.75;

/// Steps in a collision for dense flow, whose contacts last (VAJONT.md: no effect down to 4.3);
/// single collisions want 20 to 50 (PHYSICS.md 4.1).
constexpr double steps_per_contact = 6;

}  // namespace slidewave::limits
