// What a set-up LAMMPS scene says about itself: facts that both sides of a run must agree about,
// and numbers that need the neighbour list.
#pragma once

#include <optional>
#include <string>

#include "slidewave/engine.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::lammps {

/// Sum of all fix gravity [m/s2], zero without one; nothing where it varies in time.
std::optional<Vec3> gravity(LAMMPS_NS::LAMMPS& lmp);
/// "p" (periodic) or "b" (bounded) for x, y, z, e.g. "bpb".
std::string boundaries(LAMMPS_NS::LAMMPS const& lmp);
/// This rank's part of the box [m].
Box sub_domain(LAMMPS_NS::LAMMPS const& lmp);
/// The image of `position_m` inside the periodic box.
Vec3 wrapped(LAMMPS_NS::LAMMPS const& lmp, double const* position_m);
/// Largest overlap of a pair of this rank over the smaller diameter of the two [-], from the
/// neighbour list of the last step; there must have been one.
double max_overlap(LAMMPS_NS::LAMMPS const& lmp);

}  // namespace slidewave::lammps
