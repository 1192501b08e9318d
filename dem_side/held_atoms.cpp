#include "held_atoms.h"

#include <cstring>

#include "atom.h"
#include "expose.h"
#include "fix.h"
#include "fix_setforce.h"
#include "lammps.h"
#include "modify.h"

using LAMMPS_NS::Fix;
using LAMMPS_NS::FixSetForce;

namespace slidewave::dem {

// 0 where a component of fix setforce is NULL: left free.
struct XStyleTag {
  using type = int FixSetForce::*;
  friend type get(XStyleTag);
};
struct YStyleTag {
  using type = int FixSetForce::*;
  friend type get(YStyleTag);
};
struct ZStyleTag {
  using type = int FixSetForce::*;
  friend type get(ZStyleTag);
};
template struct Expose<XStyleTag, &FixSetForce::xstyle>;
template struct Expose<YStyleTag, &FixSetForce::ystyle>;
template struct Expose<ZStyleTag, &FixSetForce::zstyle>;

void HeldAtoms::find(LAMMPS_NS::LAMMPS& lmp) {
  held_groups_ = {0, 0, 0};
  integrated_groups_ = 0;
  for (int i = 0; i < lmp.modify->nfix; ++i) {
    Fix* const fix = lmp.modify->fix[i];
    if (fix->time_integrate && !std::strstr(fix->style, "noforce")) {
      integrated_groups_ |= fix->groupbit;
    }
    if (std::strcmp(fix->style, "freeze") == 0) {
      for (int& groups : held_groups_) {
        groups |= fix->groupbit;
      }
    }
    if (auto* const set = dynamic_cast<FixSetForce*>(fix)) {
      std::array<bool, 3> const sets = {set->*get(XStyleTag{}) != 0, set->*get(YStyleTag{}) != 0,
                                        set->*get(ZStyleTag{}) != 0};
      for (unsigned axis = 0; axis < 3; ++axis) {
        held_groups_[axis] |= sets[axis] ? fix->groupbit : 0;
      }
    }
  }
}

std::string HeldAtoms::partly_held(LAMMPS_NS::LAMMPS& lmp) const {
  unsigned axes = 0;
  for (int i = 0; i < lmp.atom->nlocal; ++i) {
    unsigned of_atom = 0;
    for (int axis = 0; axis < 3; ++axis) {
      of_atom |= held(lmp.atom->mask[i], axis) ? 1U << static_cast<unsigned>(axis) : 0U;
    }
    axes |= of_atom == 7U ? 0U : of_atom;
  }
  MPI_Allreduce(MPI_IN_PLACE, &axes, 1, MPI_UNSIGNED, MPI_BOR, lmp.world);
  std::string letters;
  for (unsigned axis = 0; axis < 3; ++axis) {
    letters += axes & 1U << axis ? std::string(1, "xyz"[axis]) : "";
  }
  return letters;
}

}  // namespace slidewave::dem
