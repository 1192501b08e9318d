// Stiff regime, fluid side: drag that is right for any K W/m (docs/stability.md, docs/theory.md).
//
// The pressure gradient that acts on a grain contains the reaction B/eps of the drag itself. Taken
// out of it, drag acts with K/eps towards the fluid and, by continuity, with K phi/eps^2 towards
// the other grains: together K/eps^2 towards eps u + phi v*, v* the solid's velocity that the fluid
// saw.
#pragma once

#include "closures.hpp"

namespace slidewave {

/// Before the solve. From drag K, velocity, fluid_velocity (of the window's start), void_fraction,
/// density, radius, mass, other_force, stiffness, solid_velocity and repaid (ledger over window,
/// N): response [kg/s] and repaid [N], so that the fluid loses response (u - velocity) - repaid [N]
/// to the grain, which is the force that it will receive as far as can be foreseen.
void foresee(double window_s, Vec3 const& gravity_m_s2, RowRange rows, Table& particles);

/// After the solve. Turns drag, fluid_velocity and force into those of the kick, from drag_reaction
/// B/eps [Pa/m]; adds to given the impulse that the pressure no longer hands over.
void answer_in_kick_form(double window_s, Vec3 const& in_plane, Table& particles);

}  // namespace slidewave
