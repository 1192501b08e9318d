#include "touching.h"

#include "compute.h"
#include "force.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"

namespace slidewave::dem {

void Touching::add(LAMMPS_NS::LAMMPS& lmp) {
  if (!lmp.force->pair) {
    return;
  }
  lmp.input->one("compute slidewave_touching all contact/atom");
  contacts_ = lmp.modify->compute[lmp.modify->find_compute("slidewave_touching")];
}

void Touching::count() {
  if (contacts_) {
    contacts_->compute_peratom();
    counted_ = true;
  }
}

bool Touching::touches(int atom) const {
  return counted_ && contacts_->vector_atom[atom] > 0;
}

}  // namespace slidewave::dem
