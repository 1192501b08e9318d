// What rolling and twisting springs are made of: stiffness and limit moment of a contact.
//
// Jiang, Shen & Wang 2015 (Comput. Geotech. 65, 147), 3-D: the bodies touch over a disc of radius
// R_b = b R, R = 2 R1 R2/(R1 + R2) (2 R1 at a wall):
//   rolling  k = kn R_b^2/4,  limit = 0.25 zeta_c R_b F_n     (zeta_c: local crushing)
//   twisting k = ks R_b^2/2,  limit = 0.65 mu R_b F_n
// Iwashita & Oda 1998 (J. Eng. Mech. 124, 285): k given, limit = eta R' F_n with
//   R' = R1 R2/(R1 + R2) (R1 at a wall).
#pragma once

#include <cmath>

#include "rolling_spring.h"

namespace slidewave::dem {

/// R1 R2/(R1 + R2) of a pair, R1 at a wall [m].
inline double reduced_radius(double r1_m, double r2_m, bool wall) {
  return wall ? r1_m : r1_m * r2_m / (r1_m + r2_m);
}

struct Jiang {
  double shape = 0;     ///< b
  double crushing = 0;  ///< zeta_c

  RotationSpring rolling(double kn, double normal_force_N, double reduced_m) const {
    double const disc_m = shape * 2 * reduced_m;
    return {0.25 * kn * disc_m * disc_m, 0.25 * crushing * disc_m * std::abs(normal_force_N)};
  }
  RotationSpring twisting(double ks, double mu, double normal_force_N, double reduced_m) const {
    double const disc_m = shape * 2 * reduced_m;
    return {0.5 * ks * disc_m * disc_m, 0.65 * mu * disc_m * std::abs(normal_force_N)};
  }
};

struct IwashitaOda {
  double kr = 0;   ///< [N m/rad]
  double eta = 0;  ///< limit moment over F_n R'

  RotationSpring rolling(double normal_force_N, double reduced_m) const {
    return {kr, eta * reduced_m * std::abs(normal_force_N)};
  }
};

}  // namespace slidewave::dem
