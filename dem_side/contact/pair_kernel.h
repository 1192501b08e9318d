// The contact loop: one function a set of features, with nothing in it that its set does not need.
// Geometry of a contact: spheres of radii r1, r2 overlap by delta; the contact point lies
// r - delta/2 from each centre (lever arm of the tangential force).
#pragma once

#include <cmath>

#include "contact_books.h"
#include "coulomb_slider.h"
#include "linear_spring.h"
#include "pair_list.h"
#include "rolling_laws.h"

namespace slidewave::dem {

/// Constants of a pair law; what its kernel does not use is ignored.
struct PairLaw {
  LinearSpring normal;
  CoulombSlider slider;
  Jiang jiang;
  IwashitaOda iwashita_oda;
};

enum class Rolling { off, jiang, jiang_twist, iwashita_oda };

template <bool friction, Rolling rolling, bool damped>
class PairKernel {
 public:
  static constexpr bool rolls = rolling != Rolling::off;
  static constexpr bool twists = rolling == Rolling::jiang_twist;
  static constexpr std::size_t roll_at = friction ? 3 : 0;
  static constexpr std::size_t twist_at = roll_at + 3;
  static constexpr std::size_t numbers = roll_at + (rolls ? 3 : 0) + (twists ? 1 : 0);

  /// Forces and moments of all pairs, into the loads. `tally(i, body, force, branch)` is called for
  /// each contact.
  template <class Tally>
  static void run(PairLaw const& law, PairList& pairs, double dt_s, bool advance, Dissipated& lost,
                  Tally const& tally);

  /// Energy in the springs at the positions of the last run().
  static Elastic elastic(PairLaw const& law, PairList const& pairs);

 private:
  static RotationSpring rolling_spring(PairLaw const& law, double normal_force_N, double ra,
                                       double rb) {
    double const reduced_m = reduced_radius(ra, rb, false);
    return rolling == Rolling::iwashita_oda
               ? law.iwashita_oda.rolling(normal_force_N, reduced_m)
               : law.jiang.rolling(law.normal.kn, normal_force_N, reduced_m);
  }
  static RotationSpring twisting_spring(PairLaw const& law, double normal_force_N, double ra,
                                        double rb) {
    return law.jiang.twisting(law.slider.ks, law.slider.mu, normal_force_N,
                              reduced_radius(ra, rb, false));
  }
  static double square(double const* s) { return s[0] * s[0] + s[1] * s[1] + s[2] * s[2]; }
  static void open(PairLaw const& law, double* history, double share, double ra, double rb,
                   Dissipated& lost);
};

template <bool friction, Rolling rolling, bool damped>
void PairKernel<friction, rolling, damped>::open(PairLaw const& law, double* history, double share,
                                                 double ra, double rb, Dissipated& lost) {
  if constexpr (friction) {
    lost.friction += share * 0.5 * law.slider.ks * square(history);
  }
  if constexpr (rolls) {
    lost.rolling += share * 0.5 * rolling_spring(law, 0, ra, rb).k * square(history + roll_at);
  }
  if constexpr (twists) {
    lost.rolling +=
        share * 0.5 * twisting_spring(law, 0, ra, rb).k * history[twist_at] * history[twist_at];
  }
  for (std::size_t k = 0; k < numbers; ++k) {
    history[k] = 0;
  }
}

template <bool friction, Rolling rolling, bool damped>
template <class Tally>
void PairKernel<friction, rolling, damped>::run(PairLaw const& law, PairList& pairs, double dt_s,
                                                bool advance, Dissipated& lost,
                                                Tally const& tally) {
  Body const* const bodies = pairs.bodies.data();
  Load* const loads = pairs.loads.data();
  Neighbour const* const neighbours = pairs.neighbours.data();
  std::uint8_t* const touching = pairs.touching.data();
  double* const all_history = pairs.history.data();
  std::array<double, 3> const* const shifts = pairs.shifts.data();
  std::size_t const locals = pairs.locals();
  Dissipated sum;

  for (std::size_t i = 0; i < locals; ++i) {
    Body const& a = bodies[i];
    Load on_a{};
    std::size_t const last = pairs.first[i + 1];
    for (std::size_t pair = pairs.first[i]; pair < last; ++pair) {
      auto const j = static_cast<std::size_t>(neighbours[pair].body);
      Body const& b = bodies[j];
      double const* const shift = shifts[neighbours[pair].shift].data();
      double const d[3] = {a.x[0] - (b.x[0] + shift[0]), a.x[1] - (b.x[1] + shift[1]),
                           a.x[2] - (b.x[2] + shift[2])};
      double const square_m2 = square(d);
      double const reach_m = a.radius + b.radius;
      double* const history = all_history + pair * numbers;
      if (square_m2 >= reach_m * reach_m) {
        if (touching[pair]) {
          touching[pair] = 0;
          open(law, history, j < locals ? 1.0 : 0.5, a.radius, b.radius, sum);
        }
        continue;
      }
      touching[pair] = 1;
      double const distance_m = std::sqrt(square_m2);
      double const inverse = 1 / distance_m;
      double const n[3] = {d[0] * inverse, d[1] * inverse, d[2] * inverse};
      double const overlap_m = reach_m - distance_m;
      double const share = j < locals ? 1.0 : 0.5;

      double m_eff = 0;
      double parting = 0;
      double v[3] = {0, 0, 0};
      if constexpr (friction || damped) {
        for (int k = 0; k < 3; ++k) {
          v[k] = a.v[k] - b.v[k];
        }
        parting = v[0] * n[0] + v[1] * n[1] + v[2] * n[2];
      }
      double normal_N = law.normal.kn * overlap_m;
      if constexpr (damped) {
        m_eff = 1 / (a.inverse_mass + b.inverse_mass);
        double const elastic_N = normal_N;
        normal_N = law.normal.force(overlap_m, parting, m_eff);
        if (advance) {
          sum.damping += share * (elastic_N - normal_N) * parting * dt_s;
        }
      }
      double f[3] = {normal_N * n[0], normal_N * n[1], normal_N * n[2]};
      double ta[3] = {0, 0, 0};
      double tb[3] = {0, 0, 0};
      if constexpr (friction) {
        double const arm_a = a.radius - 0.5 * overlap_m;
        double const arm_b = b.radius - 0.5 * overlap_m;
        double const w[3] = {arm_a * a.omega[0] + arm_b * b.omega[0],
                             arm_a * a.omega[1] + arm_b * b.omega[1],
                             arm_a * a.omega[2] + arm_b * b.omega[2]};
        double const slip[3] = {v[0] - parting * n[0] - (n[2] * w[1] - n[1] * w[2]),
                                v[1] - parting * n[1] - (n[0] * w[2] - n[2] * w[0]),
                                v[2] - parting * n[2] - (n[1] * w[0] - n[0] * w[1])};
        double t[3];
        sum.friction +=
            share * law.slider.force(history, n, slip, dt_s, normal_N, m_eff, advance, t);
        double const moment[3] = {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2],
                                  n[0] * t[1] - n[1] * t[0]};
        for (int k = 0; k < 3; ++k) {
          f[k] += t[k];
          ta[k] -= arm_a * moment[k];
          tb[k] -= arm_b * moment[k];
        }
      }
      if constexpr (rolls) {
        double const omega[3] = {a.omega[0] - b.omega[0], a.omega[1] - b.omega[1],
                                 a.omega[2] - b.omega[2]};
        double moment[3];
        double heat = rolling_moment(rolling_spring(law, normal_N, a.radius, b.radius),
                                     history + roll_at, n, omega, dt_s, advance, moment);
        if constexpr (twists) {
          double const along = twisting_moment(
              twisting_spring(law, normal_N, a.radius, b.radius), history + twist_at,
              omega[0] * n[0] + omega[1] * n[1] + omega[2] * n[2], dt_s, advance, heat);
          for (int k = 0; k < 3; ++k) {
            moment[k] += along * n[k];
          }
        }
        sum.rolling += share * heat;
        for (int k = 0; k < 3; ++k) {
          ta[k] += moment[k];
          tb[k] -= moment[k];
        }
      }
      Load& on_b = loads[j];
      for (int k = 0; k < 3; ++k) {
        on_a.force[k] += f[k];
        on_b.force[k] -= f[k];
      }
      if constexpr (friction || rolls) {
        for (int k = 0; k < 3; ++k) {
          on_a.torque[k] += ta[k];
          on_b.torque[k] += tb[k];
        }
      }
      tally(i, neighbours[pair].body, f, d);
    }
    for (int k = 0; k < 3; ++k) {
      loads[i].force[k] += on_a.force[k];
      loads[i].torque[k] += on_a.torque[k];
    }
  }
  lost.friction += sum.friction;
  lost.damping += sum.damping;
  lost.rolling += sum.rolling;
}

template <bool friction, Rolling rolling, bool damped>
Elastic PairKernel<friction, rolling, damped>::elastic(PairLaw const& law, PairList const& pairs) {
  Elastic sum;
  for (std::size_t i = 0; i < pairs.locals(); ++i) {
    Body const& a = pairs.bodies[i];
    for (std::size_t pair = pairs.first[i]; pair < pairs.first[i + 1]; ++pair) {
      if (!pairs.touching[pair]) {
        continue;
      }
      auto const j = static_cast<std::size_t>(pairs.neighbours[pair].body);
      Body const& b = pairs.bodies[j];
      auto const& shift = pairs.shifts[static_cast<std::size_t>(pairs.neighbours[pair].shift)];
      double d[3];
      for (std::size_t k = 0; k < 3; ++k) {
        d[k] = a.x[k] - (b.x[k] + shift[k]);
      }
      double const half = j < pairs.locals() ? 0.5 : 0.25;
      double const overlap_m = a.radius + b.radius - std::sqrt(square(d));
      double const* const history = pairs.history.data() + pair * numbers;
      sum.normal += half * law.normal.kn * overlap_m * overlap_m;
      if constexpr (friction) {
        sum.tangential += half * law.slider.ks * square(history);
      }
      if constexpr (rolls) {
        sum.rolling +=
            half * rolling_spring(law, 0, a.radius, b.radius).k * square(history + roll_at);
      }
      if constexpr (twists) {
        sum.rolling += half * twisting_spring(law, 0, a.radius, b.radius).k * history[twist_at] *
                       history[twist_at];
      }
    }
  }
  return sum;
}

}  // namespace slidewave::dem
