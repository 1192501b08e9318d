// The concurrent scheme: both sides advance at once, each with the other's last state.
//
// A particle then answers the fluid's velocity of the window's start (exactly, b = K W/m), and the
// fluid takes the drag of the window's start as a constant force (a = K W/m_fluid = M b, m_fluid
// the fluid that shares the particle's kernel, M the mass loading). With what the ledger repays a
// slip becomes s_(n+1) = (exp(-b) - a) s_n + M (b - 1 + exp(-b)) s_(n-1): up to a = 0.2 and b = 0.3
// it falls without a change of sign; where exp(-b) < a it turns in every window, and for large b it
// grows (tests/physics/test_concurrent.cpp).
//
// The pressure gradient is a window older than in the serial scheme. With d_n the change of
// velocity in window n, added mass makes d_n = -S/2 (d_(n-2) + d_(n-3)), where the serial scheme
// has d_n = -S/2 (d_(n-1) + d_(n-2)): stable to S = 1.24 instead of 2. A contact wave of w W is fed
// from 0.56 (S = 1), 0.94 (S = 0.57), 1.24 (S = 0.05) on instead of 1.46, 1.76 and 2.08
// (tests/physics/test_skeleton_wave.cpp). Limits keep the distance that the serial ones keep.
#pragma once

namespace slidewave::limits {

constexpr double concurrent_fluid_stiffness = 0.2;       ///< K W/m_fluid
constexpr double concurrent_particle_stiffness = 0.3;    ///< K W/m
constexpr double concurrent_added_mass_number = 0.6;     ///< S
constexpr double comfortable_concurrent_wave_run = 0.6;  ///< c W/L
constexpr double largest_concurrent_wave_run = 1.0;

/// K W/m_fluid of a mixture: x = K W/m, loading = solid mass/fluid mass.
inline double fluid_stiffness(double stiffness_x, double mass_loading) {
  return stiffness_x * mass_loading;
}

}  // namespace slidewave::limits
