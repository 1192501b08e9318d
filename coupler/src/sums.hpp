// What each side adds up over its ranks in a window, as plain numbers so that one reduction does.
#pragma once

#include <algorithm>

#include "profile.hpp"

namespace slidewave {

/// All members are sums over the ranks of the particle side.
struct DemSums {
  double particles = 0;
  double mass_kg = 0;
  double volume_m3 = 0;        ///< of particles that the fluid sees
  double nearest_cell = 0;     ///< particles placed in the nearest cell of the mesh
  double outside = 0;          ///< particles that no fluid acts on
  double received[3] = {};     ///< drag impulse of the window, from the particle engine [kg m/s]
  double received_abs = 0;     ///< sum of its magnitudes over the particles
  double ledger[3] = {};       ///< given less received, after the window [kg m/s]
  double drag_response = 0;    ///< DemWatch's, of all ranks on the first one, else 0
  double kernels_crossed = 0;  ///< likewise
  double seconds[Profile::phases] = {};
  double processor_seconds[Profile::phases] = {};
};

/// All members are sums over the ranks of the fluid side.
struct FluidSums {
  double given[3] = {};              ///< from the solved momentum equation [kg m/s]
  double solid_volume_m3 = 0;        ///< of the stored solid fraction
  double cell_pressure[3] = {};      ///< integral of solid fraction times grad p over the cells [N]
  double particle_pressure[3] = {};  ///< sum of V grad p at the particles [N]
  double particle_pressure_abs = 0;
  double ledger_in_air[3] = {};  ///< kept by particles in air, not repaid [kg m/s]
  double seconds[Profile::phases] = {};
  double processor_seconds[Profile::phases] = {};
};

template <class Sums>
void take_times(Profile const& profile, Sums& sums) {
  std::copy(profile.seconds.begin(), profile.seconds.end(), sums.seconds);
  std::copy(profile.processor_seconds.begin(), profile.processor_seconds.end(),
            sums.processor_seconds);
}

template <class Sums>
constexpr int count_of() {
  static_assert(sizeof(Sums) % sizeof(double) == 0);
  return static_cast<int>(sizeof(Sums) / sizeof(double));
}

template <class Sums>
double* numbers_of(Sums& sums) {
  return reinterpret_cast<double*>(&sums);
}

}  // namespace slidewave
