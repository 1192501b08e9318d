// Which atoms touch another one, asked of LIGGGHTS' own compute.
#pragma once

namespace LAMMPS_NS {
class Compute;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace slidewave::dem {

class Touching {
 public:
  /// Adds the compute, before the scene is set up. Nothing touches in a scene without a pair style.
  void add(LAMMPS_NS::LAMMPS& lmp);
  /// Counts the contacts of now; all ranks together.
  void count();
  /// Of a local atom, as of the last count().
  bool touches(int atom) const;

 private:
  LAMMPS_NS::Compute* contacts_ = nullptr;
  bool counted_ = false;
};

}  // namespace slidewave::dem
