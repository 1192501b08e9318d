// Stiff regime, particle side: what the fluid must know of each grain to foresee its window.
#pragma once

#include "slidewave/table.hpp"

namespace slidewave {

/// Components of `memory` behind the ledger and the home: force of the others a window ago (3) and
/// the stiffness estimated then.
constexpr int contact_memory = 4;

/// Fills derived solid_velocity [m/s] (travel over the last window, of `last_window_s`: what the
/// ramp of the void fraction shows to the fluid; at first the velocity, or a suspension that starts
/// in motion would be stopped for a window), other_force [N] and stiffness [N/m] from the
/// gathered travel, other_force, stiffest, mass and memory.
void recall_contacts(Table const& particles, double last_window_s, Vec3 const& gravity_m_s2,
                     Table& derived);
/// Writes what the next recall needs into the answers' memory.
void keep_contacts(Table const& derived, Table& answers);

}  // namespace slidewave
