// The particles of a LIGGGHTS run through a checkpoint: every value that migrates with an atom
// (LIGGGHTS' own exchange record: position to spin, contact histories of pairs and walls, columns)
// and the forces on it, exactly as they are.
//
// A run that saves drops its atoms and takes them from the record again, just as a run that goes on
// does: both then have the same order of atoms, ghosts and neighbours, and take the same steps.
#pragma once

#include <string>

#include "slidewave/state.hpp"

namespace LAMMPS_NS {
class FixSlidewave;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace slidewave::dem {

/// A fix that keeps more than what is passed here, so that a run with it has no checkpoints;
/// empty: none.
std::string fix_without_checkpoint(LAMMPS_NS::LAMMPS& lmp);

/// To be called with the integrator set up. `kick` may be null. All ranks together.
void pass_atoms(LAMMPS_NS::LAMMPS& lmp, State& state, LAMMPS_NS::FixSlidewave* kick);

}  // namespace slidewave::dem
