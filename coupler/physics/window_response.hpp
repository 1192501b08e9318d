// What a grain does in a window, ahead of time: a damped oscillator that a constant force pushes,
//
//   m y'' + K y' + k y = f,   y(0) = 0, y'(0) = v:     y(W) = velocity_s v + force_m_N f
//
// with K [kg/s] its drag, k [N/m] the stiffness of its contacts, W [s] the window. The fluid needs
// y before the particles move: the drag's impulse over the window is K (u W - y). Exact for K W/m
// and k W^2/m from 0 to any size; k = held_stiffness: y = v W, whatever pushes. Source: linear
// oscillator; use in docs/stability.md.
#pragma once

#include <cmath>

namespace slidewave {

/// From here on a grain moves as its velocity says and feels no force (frozen, prescribed motion).
constexpr double held_stiffness = 1e300;

struct WindowResponse {
  double velocity_s = 0;  ///< y(W) of unit velocity [s]
  double force_m_N = 0;   ///< y(W) of unit force [m/N]
};

namespace response_detail {

/// (1 - e^-z)/z.
inline double phi1(double z) {
  return std::abs(z) < 1e-8 ? 1 - z / 2 : -std::expm1(-z) / z;
}

/// g(1) and the integral of g over (0, 1), where g'' + x g' + s g = 0, g(0) = 0, g'(0) = 1.
struct Unit {
  double end;
  double integral;
};

inline Unit unit_response(double x, double s) {
  if (x < 0.5 && s < 0.5) {  // power series of g: all closed forms cancel here
    double before = 0, coefficient = 1, end = 1, integral = 0.5;
    for (int n = 0; n < 24; ++n) {
      double const next = -(x * (n + 1) * coefficient + s * before) / ((n + 1) * (n + 2));
      before = coefficient;
      coefficient = next;
      end += next;
      integral += next / (n + 3);
    }
    return {end, integral};
  }
  double const square = x * x / 4 - s;
  if (square > 0.01 * (1 + s)) {  // two decays
    double const root = std::sqrt(square);
    double const fast = x / 2 + root, slow = s / fast;
    return {std::exp(-slow) * phi1(2 * root), (phi1(slow) - phi1(fast)) / (2 * root)};
  }
  double const decay = std::exp(-x / 2);
  double sine = 0, cosine = 0;  // sin(w)/w and cos(w), w^2 = -square
  if (std::abs(square) < 1e-3) {
    sine = 1 + square / 6 * (1 + square / 20);
    cosine = 1 + square / 2 * (1 + square / 12);
  } else if (square > 0) {
    double const root = std::sqrt(square);
    sine = std::sinh(root) / root;
    cosine = std::cosh(root);
  } else {
    double const root = std::sqrt(-square);
    sine = std::sin(root) / root;
    cosine = std::cos(root);
  }
  double const slope = decay * (cosine - x / 2 * sine);
  return {decay * sine, (1 - slope - x * decay * sine) / s};
}

}  // namespace response_detail

inline WindowResponse window_response(double mass_kg, double drag_kg_s, double stiffness_N_m,
                                      double window_s) {
  if (stiffness_N_m >= held_stiffness) {
    return {window_s, 0};
  }
  auto const unit = response_detail::unit_response(drag_kg_s * window_s / mass_kg,
                                                   stiffness_N_m * window_s * window_s / mass_kg);
  return {window_s * unit.end, window_s * window_s / mass_kg * unit.integral};
}

}  // namespace slidewave
