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
  /// Numbers that a contact must remember: slip (3), rolling (3), twist (1).
  static constexpr std::size_t numbers = (friction ? 3 : 0) + (rolls ? 3 : 0) + (twists ? 1 : 0);
  /// Registers of history: slip; rolling with the twist as the fourth number.
  static constexpr std::size_t roll_at = friction ? 1 : 0;
  static constexpr std::size_t registers = roll_at + (rolls ? 1 : 0);

  /// Forces and moments of all pairs, into the loads. `tally(i, body, force, branch)` is called for
  /// each contact. Heat of this step is added to `lost` if the history advances.
  template <class Tally>
  static SLIDEWAVE_INLINE void run(PairLaw const& law, PairList& pairs, double dt_s, bool advance,
                                   Dissipated& lost, Tally const& tally);

  /// Energy in the springs at the positions of the last run().
  static Elastic elastic(PairLaw const& law, PairList const& pairs);

 private:
  static SLIDEWAVE_INLINE RotationSpring rolling_spring(PairLaw const& law, double normal_force_N,
                                                        double ra, double rb) {
    double const reduced_m = reduced_radius(ra, rb, false);
    return rolling == Rolling::iwashita_oda
               ? law.iwashita_oda.rolling(normal_force_N, reduced_m)
               : law.jiang.rolling(law.normal.kn, normal_force_N, reduced_m);
  }
  static SLIDEWAVE_INLINE RotationSpring twisting_spring(PairLaw const& law, double normal_force_N,
                                                         double ra, double rb) {
    return law.jiang.twisting(law.slider.ks, law.slider.mu, normal_force_N,
                              reduced_radius(ra, rb, false));
  }
  /// Energy in the springs that keep a history.
  static Elastic kept(PairLaw const& law, Slot const* history, double ra, double rb) {
    Elastic sum;
    if constexpr (friction) {
      sum.tangential = 0.5 * law.slider.ks * dot(history[0].v, history[0].v);
    }
    if constexpr (rolls) {
      Vec4 const theta = three(history[roll_at].v);
      sum.rolling = 0.5 * rolling_spring(law, 0, ra, rb).k * dot(theta, theta);
    }
    if constexpr (twists) {
      double const angle = history[roll_at].v[3];
      sum.rolling += 0.5 * twisting_spring(law, 0, ra, rb).k * angle * angle;
    }
    return sum;
  }
};

template <bool friction, Rolling rolling, bool damped>
template <class Tally>
void PairKernel<friction, rolling, damped>::run(PairLaw const& law, PairList& pairs, double dt_s,
                                                bool advance, Dissipated& lost,
                                                Tally const& tally) {
  Body const* const bodies = pairs.bodies.data();
  Load* const loads = pairs.loads.data();
  Neighbour const* const neighbours = pairs.neighbours.data();
  std::uint8_t* const touching = pairs.touching.data();
  Slot const* const shifts = pairs.shifts.data();
  std::size_t const locals = pairs.locals();
  Dissipated sum;

  for (std::size_t i = 0; i < locals; ++i) {
    Body const a = bodies[i];
    Vec4 force_a{};
    Vec4 torque_a{};
    std::size_t const last = pairs.first[i + 1];
    for (std::size_t pair = pairs.first[i]; pair < last; ++pair) {
      auto const j = static_cast<std::size_t>(neighbours[pair].body);
      Body const& b = bodies[j];
      Vec4 const d = three(a.x - (b.x + shifts[neighbours[pair].shift].v));
      double const square_m2 = dot(d, d);
      double const reach_m = a.radius() + b.radius();
      Slot* const history = pairs.history.data() + pair * registers;
      double const share = j < locals ? 1.0 : 0.5;
      if (square_m2 >= reach_m * reach_m) {
        if (touching[pair]) {
          touching[pair] = 0;
          Elastic const freed = kept(law, history, a.radius(), b.radius());
          sum.friction += share * freed.tangential;
          sum.rolling += share * freed.rolling;
          for (std::size_t k = 0; k < registers; ++k) {
            history[k].v = Vec4{};
          }
        }
        continue;
      }
      touching[pair] = 1;
      double const distance_m = std::sqrt(square_m2);
      Vec4 const n = d * (1 / distance_m);
      double const overlap_m = reach_m - distance_m;

      double m_eff = 0;
      double parting = 0;
      Vec4 v{};
      if constexpr (friction || damped) {
        v = three(a.v - b.v);
        parting = dot(v, n);
      }
      double normal_N = law.normal.kn * overlap_m;
      if constexpr (damped) {
        m_eff = 1 / (a.inverse_mass() + b.inverse_mass());
        double const elastic_N = normal_N;
        normal_N = law.normal.force(overlap_m, parting, m_eff);
        sum.damping += advance ? share * (elastic_N - normal_N) * parting * dt_s : 0.0;
      }
      Vec4 f = normal_N * n;
      Vec4 ta{};
      Vec4 tb{};
      if constexpr (friction) {
        double const arm_a = a.radius() - 0.5 * overlap_m;
        double const arm_b = b.radius() - 0.5 * overlap_m;
        Vec4 const slip = v - parting * n + cross(n, arm_a * a.omega + arm_b * b.omega);
        Vec4 t;
        sum.friction +=
            share * law.slider.force(history[0].v, n, slip, dt_s, normal_N, m_eff, advance, t);
        Vec4 const moment = cross(n, t);
        f += t;
        ta = -arm_a * moment;
        tb = -arm_b * moment;
      }
      if constexpr (rolls) {
        Vec4 const omega = a.omega - b.omega;
        Vec4 theta = three(history[roll_at].v);
        double twist = history[roll_at].v[3];
        Vec4 moment;
        double heat = rolling_moment(rolling_spring(law, normal_N, a.radius(), b.radius()), theta,
                                     n, omega, dt_s, advance, moment);
        if constexpr (twists) {
          moment += n * twisting_moment(twisting_spring(law, normal_N, a.radius(), b.radius()),
                                        twist, dot(omega, n), dt_s, advance, heat);
        }
        theta[3] = twist;
        history[roll_at].v = theta;
        sum.rolling += share * heat;
        ta += moment;
        tb -= moment;
      }
      force_a += f;
      loads[j].force -= f;
      if constexpr (friction || rolls) {
        torque_a += ta;
        loads[j].torque += tb;
      }
      tally(i, neighbours[pair].body, f, d);
    }
    loads[i].force += force_a;
    loads[i].torque += torque_a;
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
      auto const image = static_cast<std::size_t>(pairs.neighbours[pair].shift);
      Vec4 const d = three(a.x - (b.x + pairs.shifts[image].v));
      double const share = j < pairs.locals() ? 1.0 : 0.5;
      double const overlap_m = a.radius() + b.radius() - std::sqrt(dot(d, d));
      Elastic const springs =
          kept(law, pairs.history.data() + pair * registers, a.radius(), b.radius());
      sum.normal += share * 0.5 * law.normal.kn * overlap_m * overlap_m;
      sum.tangential += share * springs.tangential;
      sum.rolling += share * springs.rolling;
    }
  }
  return sum;
}

}  // namespace slidewave::dem
