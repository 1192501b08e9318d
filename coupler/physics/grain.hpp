// What a drag law sees: one grain and the fluid at it.
#pragma once

namespace slidewave {

struct Grain {
  double diameter_m = 0;      ///< of the grain, not of a coarse-grained particle
  double slip_m_s = 0;        ///< |u_f - v|, interstitial
  double density_kg_m3 = 0;   ///< fluid
  double viscosity_Pa_s = 0;  ///< fluid
  double void_fraction = 1;   ///< 0.15 to 1

  /// Reynolds number of the superficial slip eps |u_f - v|, the one that the laws take.
  double reynolds() const {
    return void_fraction * density_kg_m3 * slip_m_s * diameter_m / viscosity_Pa_s;
  }
};

/// Formulation A: the particle also feels -V grad p. B: drag carries all but buoyancy, K_B =
/// K_A/eps in a uniform bed (Zhou et al. 2010, sets I and II; PHYSICS.md 1.3). Laws here give K of
/// A.
enum class Formulation { A, B };

/// From a law's K [kg/s] to the K of the formulation.
inline double in_formulation(Formulation formulation, double drag_kg_s, double void_fraction) {
  return formulation == Formulation::A ? drag_kg_s : drag_kg_s / void_fraction;
}

}  // namespace slidewave
