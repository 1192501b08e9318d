// What a set-up LIGGGHTS scene says about itself: facts that both sides of a run must agree about.
#pragma once

#include <optional>
#include <string>

#include "slidewave/engine.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::dem {

/// Sum of all fix gravity [m/s2], zero without one; nothing where it varies in time.
std::optional<Vec3> gravity(LAMMPS_NS::LAMMPS& lmp);
/// "p" (periodic) or "b" (bounded) for x, y, z, e.g. "bpb".
std::string boundaries(LAMMPS_NS::LAMMPS& lmp);
/// This rank's part of the box [m].
Box sub_domain(LAMMPS_NS::LAMMPS& lmp);
/// The image of `position_m` inside the periodic box.
Vec3 wrapped(LAMMPS_NS::LAMMPS& lmp, double const* position_m);
/// Largest overlap of this rank's pairs over the smaller diameter of the two [-], from the
/// neighbour list of the last step; 0 before the first.
double max_overlap(LAMMPS_NS::LAMMPS& lmp);

/// A mesh wall whose extent along a periodic axis of the box is longer than the period.
struct WideMesh {
  std::string name;
  int axis = 0;
  double extent_m = 0;
  double period_m = 0;
};
/// The first such wall: LIGGGHTS repeats it with the period, and where its images overlap a contact
/// counts once or twice, as the order of the triangles has it, which differs with the ranks.
/// Collective.
std::optional<WideMesh> wide_mesh(LAMMPS_NS::LAMMPS& lmp);

/// Nine digits, for messages.
std::string as_text(double number);
/// Three numbers that read back to the same doubles.
std::string as_text(Vec3 const& v);

}  // namespace slidewave::dem
