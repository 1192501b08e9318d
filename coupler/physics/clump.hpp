// Coarse graining: a particle of diameter D = alpha d stands for alpha^3 grains of diameter d that
// move together. Closures are evaluated at d and summed over the grains; volume forces (weight,
// pressure gradient) see the particle's own volume and need nothing. Source: PHYSICS.md 0.5, 1.6.
#pragma once

#include <stdexcept>
#include <string>

namespace slidewave {

/// Diameter of the grains [m] in a particle of diameter D.
inline double grain_diameter(double diameter_m, double alpha) {
  return diameter_m / alpha;
}

/// How many grains a particle stands for: the factor from one grain's force, or K, to the clump's.
inline double grains_per_particle(double alpha) {
  return alpha * alpha * alpha;
}

/// How a particle's contact constants follow from those of its grains.
///
///   none          the same K (Zhao, Utili & Crosta, the Vajont paper): overlap/D grows with D
///   proportional  K ~ D: the same overlap ratio under the same stress, the same wave speed
///   sakai         the particle's contact force is the sum over its grains at the same overlap
///                 (Sakai & Koshizuka 2009, Chem. Eng. Sci. 64, 533): K ~ alpha^3, and contacts
///                 last as long as those of grains
enum class ContactScaling { none, proportional, sakai };

/// From its name in a case (`models.contact_scaling`). Throws std::invalid_argument.
inline ContactScaling contact_scaling(std::string const& name) {
  if (name == "proportional") {
    return ContactScaling::proportional;
  }
  if (name == "sakai") {
    return ContactScaling::sakai;
  }
  if (name != "none") {
    throw std::invalid_argument("contact scaling " + name + ": give none, proportional or sakai");
  }
  return ContactScaling::none;
}

/// Factors from a grain's constants to a particle's. Friction coefficients, damping ratios and
/// limits of rolling (all without dimension) do not scale; mass and inertia follow from the size.
struct ContactScale {
  double stiffness = 1;  ///< of kn, ks [N/m]
  double rotation = 1;   ///< of kr [N m/rad], a stiffness times a length squared
};

inline ContactScale contact_scale(ContactScaling scaling, double alpha) {
  switch (scaling) {
    case ContactScaling::proportional:
      return {alpha, alpha * alpha * alpha};
    case ContactScaling::sakai:
      return {grains_per_particle(alpha), grains_per_particle(alpha) * alpha * alpha};
    case ContactScaling::none:
      break;
  }
  return {};
}

}  // namespace slidewave
