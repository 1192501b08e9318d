// The particle step against the critical one of our own contact law, for the lightest particle that
// is there now: column dem_step_fraction of history.csv, warned once where `check` would refuse.
#pragma once

#include "slidewave/coupler.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::dem {

class StepWatch {
 public:
  /// Where OwnPairs::current() is the pair style: a packaged law does not tell its constants.
  StepWatch(LAMMPS_NS::LAMMPS& lmp, Session const& session) : lmp_(lmp), session_(session) {}
  /// dt over the critical step (limits/contact_step.hpp); 0 before the first step and without
  /// particles. Collective.
  Quantity observe(double dt_s);

 private:
  LAMMPS_NS::LAMMPS& lmp_;
  Session const& session_;
  bool told_ = false;
};

}  // namespace slidewave::dem
