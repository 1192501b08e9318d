// Shear lift on a sphere, Saffman 1965 with the finite-slip factor of McLaughlin 1991 as fitted by
// Mei 1992 (Int. J. Multiphase Flow 18):
//
//   F = 1.615 d^2 rho sqrt(nu |w|) J* (U x w)/|w|,   U = u - v, w = curl u, nu = mu/rho
//   s = sqrt(nu |w|)/|U|;  J* = 1 - 0.287/s^2                                      for s > 20
//   J* = 0.3 (1 + tanh(2.5 (log10 s + 0.191))) (0.667 + tanh(6 (s - 0.32)))        between
//   J* = -140 s^5 ln(1/s^2)                                                        for s < 0.1
//
// A lagging sphere is pushed to the faster fluid. The pieces differ by at most 0.005 where they
// meet; they are blended over 0.08 to 0.12 and 18 to 22. Of one grain: times alpha^3 for a clump.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace slidewave {

/// J* as a function of s >= 0; 1 where Saffman holds, 0 without shear.
inline double mei_factor(double s) {
  auto const blend = [](double x, double low, double high) {
    double const t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
  };
  if (s <= 0) {
    return 0;
  }
  double const weak = -140 * std::pow(s, 5) * -2 * std::log(s);
  if (s < 0.08) {
    return weak;
  }
  double const strong = 1 - 0.287 / (s * s);
  if (s > 22) {
    return strong;
  }
  double const middle =
      0.3 * (1 + std::tanh(2.5 * (std::log10(s) + 0.191))) * (0.667 + std::tanh(6 * (s - 0.32)));
  double const above_weak = blend(s, 0.08, 0.12);
  double const above_middle = blend(s, 18, 22);
  return (1 - above_weak) * weak +
         above_weak * ((1 - above_middle) * middle + above_middle * strong);
}

/// Lift [N] on a grain of diameter d; slip u - v [m/s], vorticity curl u [1/s].
inline Eigen::Vector3d saffman_mei_lift(double diameter_m, double density_kg_m3,
                                        double viscosity_Pa_s, Eigen::Vector3d const& slip_m_s,
                                        Eigen::Vector3d const& vorticity_1_s) {
  double const shear = vorticity_1_s.norm();
  double const slip = slip_m_s.norm();
  if (shear == 0 || slip == 0) {
    return Eigen::Vector3d::Zero();
  }
  double const diffusion = std::sqrt(viscosity_Pa_s / density_kg_m3 * shear);
  double const scale = 1.615 * diameter_m * diameter_m * density_kg_m3 * diffusion;
  return scale * mei_factor(diffusion / slip) / shear * slip_m_s.cross(vorticity_1_s);
}

}  // namespace slidewave
