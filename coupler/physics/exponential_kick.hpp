// Exact half kick of a particle under a linear drag and any constant force, all forces together:
//
//   m dv/dt = K (u - v) + F
//   v' = v_inf + (v - v_inf) exp(-K h/m),   v_inf = u + F/K
//
// with u, K, F frozen over the kick; F holds contacts, weight and all others. Written with
// phi1 = (1 - e^-x)/x and phi2 = (1 - phi1)/x, x = K h/m, it needs no division by K and loses no
// digits for x from 0 to 1e6:
//
//   v' - v       = phi1 (K (u - v) + F) h/m
//   drag impulse = m (v' - v) - F h = K h (phi1 (u - v) - phi2 F h/m)
//
// so that phi1 (K (u - v) + F) is the force to hand to an integrator that adds f h/m.
// A split (drag after the other forces) would settle too fast: 10 times at x = 10 (DESIGN.md 4).
// Units: m [kg], K [kg/s], h [s], u, v [m/s], F [N]. T is double or a fixed-size Eigen vector.
#pragma once

#include <cmath>

namespace slidewave {

/// What a kick needs of (K, m, h). Constant while these are: over a window, for all its sub-steps.
struct KickFactors {
  double phi1 = 1;    ///< (1 - e^-x)/x
  double phi2 = 0.5;  ///< (1 - phi1)/x
};

/// Factors for x = K h/m >= 0.
inline KickFactors kick_factors(double x) {
  if (x > 0.25) {
    double const phi1 = -std::expm1(-x) / x;
    return {phi1, (1 - phi1) / x};
  }
  // phi2 = 1/2! - x/3! + x^2/4! - ...: the closed form cancels here; 12 terms give round-off.
  double phi2 = 0;
  for (int k = 13; k >= 2; --k) {
    phi2 = (1 - x * phi2) / k;
  }
  return {1 - x * phi2, phi2};
}

inline KickFactors kick_factors(double drag_kg_s, double mass_kg, double h_s) {
  return kick_factors(drag_kg_s * h_s / mass_kg);
}

/// Force in, force out: with this force [N] an integrator that adds f h/m makes the exact kick.
/// `force_N` is the sum of all other forces, gravity included.
template <class T>
T effective_force(KickFactors const& factors, double drag_kg_s, T const& fluid_velocity,
                  T const& velocity, T const& force_N) {
  return factors.phi1 * (drag_kg_s * (fluid_velocity - velocity) + force_N);
}

/// phi2 h/m [s/kg], which a particle's directions have in common: velocity that a force takes off
/// the mean slip, per force.
inline double mean_response(KickFactors const& factors, double mass_kg, double h_s) {
  return factors.phi2 * h_s / mass_kg;
}

/// The drag's share of the kick [kg m/s]; `velocity` is the one before the kick.
template <class T>
T drag_impulse_of_response(KickFactors const& factors, double mean_response_s_kg, double drag_kg_s,
                           T const& fluid_velocity, T const& velocity, T const& force_N,
                           double h_s) {
  return (drag_kg_s * h_s) *
         (factors.phi1 * (fluid_velocity - velocity) - mean_response_s_kg * force_N);
}

template <class T>
T drag_impulse(KickFactors const& factors, double drag_kg_s, T const& fluid_velocity,
               T const& velocity, T const& force_N, double mass_kg, double h_s) {
  return drag_impulse_of_response(factors, mean_response(factors, mass_kg, h_s), drag_kg_s,
                                  fluid_velocity, velocity, force_N, h_s);
}

/// A kicked particle: its new velocity [m/s] and the impulse of the drag alone [kg m/s].
template <class T>
struct Kicked {
  T velocity;
  T drag_impulse;
};

template <class T>
Kicked<T> exponential_kick(T const& velocity, T const& fluid_velocity, double drag_kg_s,
                           T const& force_N, double mass_kg, double h_s) {
  KickFactors const factors = kick_factors(drag_kg_s, mass_kg, h_s);
  T const force = effective_force(factors, drag_kg_s, fluid_velocity, velocity, force_N);
  return {velocity + (h_s / mass_kg) * force,
          drag_impulse(factors, drag_kg_s, fluid_velocity, velocity, force_N, mass_kg, h_s)};
}

}  // namespace slidewave
