#include "fix_fluid_work.h"

#include "atom.h"
#include "error.h"
#include "fix_slidewave.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {

FixFluidWork::FixFluidWork(LAMMPS* lammps, int argument_count, char** arguments)
    : Fix(lammps, argument_count, arguments) {}

int FixFluidWork::setmask() {
  return FixConst::PRE_INITIAL_INTEGRATE | FixConst::POST_FORCE;
}

void FixFluidWork::init() {
  kick_ = nullptr;
  for (int k = 0; k < modify->nfix && modify->fix[k] != this; ++k) {
    if (auto* const kick = dynamic_cast<FixSlidewave*>(modify->fix[k])) {
      kick_ = kick;
    }
  }
  if (!kick_) {
    error->fix_error(FLERR, this, "must stand after fix slidewave");
  }
}

void FixFluidWork::add() {
  double const half_dt_s = 0.5 * update->dt;
  bool const turns = kick_->has("rotational_drag");
  for (int i = 0; i < atom->nlocal; ++i) {
    double const* const other = kick_->other_force_N(i);
    double const half = 0.5 * half_dt_s / atom->rmass[i];
    for (int axis = 0; axis < 3; ++axis) {
      double const f = atom->f[i][axis];
      work_J_ += (f - other[axis]) * half_dt_s * (atom->v[i][axis] + half * f);
    }
    if (turns) {
      double const* const resting = kick_->other_torque_N_m(i);
      double const half_spin = 0.5 * half_dt_s / kick_->inertia_kg_m2(static_cast<std::size_t>(i));
      for (int axis = 0; axis < 3; ++axis) {
        double const t = atom->torque[i][axis];
        work_J_ += (t - resting[axis]) * half_dt_s * (atom->omega[i][axis] + half_spin * t);
      }
    }
  }
}

}  // namespace LAMMPS_NS
