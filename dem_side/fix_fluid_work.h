// fix ID all slidewave/work: adds up the work that the fluid does on particles, as fix slidewave
// hands it to the integrator. In each half kick a force f turns v into v' = v + f dt/2m; the share
// f_fluid of f does the work f_fluid dt/2 (v + v')/2, exactly. Stands after fix slidewave; made by
// the energy audit, not for scripts.
#pragma once

#include "fix.h"

namespace LAMMPS_NS {

class FixSlidewave;

class FixFluidWork : public Fix {
 public:
  FixFluidWork(LAMMPS* lmp, int argument_count, char** arguments);
  int setmask() override;
  void init() override;
  void pre_initial_integrate() override { add(); }
  void post_force(int) override { add(); }
  /// Of this rank's atoms since the fix was made [J].
  double work_J() const { return work_J_; }
  void set_work(double joule) { work_J_ = joule; }

 private:
  void add();

  FixSlidewave* kick_ = nullptr;
  double work_J_ = 0;
};

}  // namespace LAMMPS_NS
