#include "held_atoms.h"

#include <string>

#include "fix.h"
#include "lammps.h"
#include "modify.h"
#include "registry.h"

namespace slidewave::lammps {

void HeldAtoms::find(LAMMPS_NS::LAMMPS& lmp) {
  held_groups_ = {0, 0, 0};
  integrated_groups_ = 0;
  for (int i = 0; i < lmp.modify->nfix; ++i) {
    LAMMPS_NS::Fix const& fix = *lmp.modify->fix[i];
    std::string const style = fix.style;
    if (fix.time_integrate && style.find("noforce") == std::string::npos) {
      integrated_groups_ |= fix.groupbit;
    }
    std::vector<std::string> const words = words_of_fix(fix.id);
    for (unsigned axis = 0; axis < 3; ++axis) {
      bool const set = style == "setforce" && words.size() > 3 + axis && words[3 + axis] != "NULL";
      if (style == "freeze" || set) {
        held_groups_[axis] |= fix.groupbit;
      }
    }
  }
}

}  // namespace slidewave::lammps
