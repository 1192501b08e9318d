#include "step_watch.h"

#include <algorithm>
#include <limits>

#include "atom.h"
#include "lammps.h"
#include "pair_style.h"
#include "slidewave/physics/limits/contact_step.hpp"

namespace slidewave::dem {

Quantity StepWatch::observe(double dt_s) {
  LAMMPS_NS::Atom const& atom = *lmp_.atom;
  double lightest_kg = std::numeric_limits<double>::max();
  for (int i = 0; i < atom.nlocal; ++i) {
    lightest_kg = std::min(lightest_kg, atom.rmass[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, &lightest_kg, 1, MPI_DOUBLE, MPI_MIN, lmp_.world);
  PairLaw const& law = OwnPairs::current()->law();
  double const fraction =
      dt_s / limits::critical_contact_step(lightest_kg, law.normal.kn, law.slider.ks);
  if (fraction > limits::largest_step_fraction && !told_) {
    told_ = true;
    session_.say("warning: the particle step is " + std::to_string(fraction) +
                 " of the critical step of the lightest particle's contacts; keep below " +
                 std::to_string(limits::largest_step_fraction) + " (parameters.dem_dt)");
  }
  return {"dem_step_fraction", fraction};
}

}  // namespace slidewave::dem
