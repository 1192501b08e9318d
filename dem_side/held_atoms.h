// Which components of which atoms are not free to follow the force on them: frozen (fix freeze),
// prescribed (fix setforce), or integrated by nobody. A held particle gets no kick, but the fluid
// still feels it: it books the impulse K (u - v) dt.
#pragma once

#include <array>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::dem {

class HeldAtoms {
 public:
  /// Reads the present list of fixes.
  void find(LAMMPS_NS::LAMMPS& lmp);
  /// `mask` is the atom's group mask, `axis` 0 to 2.
  bool held(int mask, int axis) const {
    return (mask & held_groups_[static_cast<unsigned>(axis)]) || !(mask & integrated_groups_);
  }
  /// Held along no axis.
  bool free(int mask) const {
    return (mask & integrated_groups_) &&
           !(mask & (held_groups_[0] | held_groups_[1] | held_groups_[2]));
  }
  /// Axes (of "xyz") along which some atom is held that is free along another. Collective.
  std::string partly_held(LAMMPS_NS::LAMMPS& lmp) const;

 private:
  std::array<int, 3> held_groups_{};
  int integrated_groups_ = 0;
};

}  // namespace slidewave::dem
