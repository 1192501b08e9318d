#include "stock_facts.h"

#include <cmath>
#include <cstdio>

#include "domain.h"
#include "expose.h"
#include "fix_gravity.h"
#include "lammps.h"
#include "modify.h"

using LAMMPS_NS::FixGravity;
using LAMMPS_NS::LAMMPS;

namespace slidewave::dem {

// 0 where magnitude and direction are constants.
struct VaryingTag {
  using type = int FixGravity::*;
  friend type get(VaryingTag);
};
template struct Expose<VaryingTag, &FixGravity::varflag>;

std::optional<Vec3> gravity(LAMMPS& lmp) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < lmp.modify->nfix; ++i) {
    if (auto* const fix = dynamic_cast<FixGravity*>(lmp.modify->fix[i])) {
      fix->init();  // works the direction out
      if (fix->*get(VaryingTag{}) != 0) {
        return std::nullopt;
      }
      Vec3 one;
      fix->get_gravity(one.data());
      sum += one;
    }
  }
  return sum;
}

std::string boundaries(LAMMPS& lmp) {
  std::string text;
  for (int const periodic : lmp.domain->periodicity) {
    text += periodic ? "p" : "b";
  }
  return text;
}

Box sub_domain(LAMMPS& lmp) {
  return {Vec3(lmp.domain->sublo), Vec3(lmp.domain->subhi)};
}

Vec3 wrapped(LAMMPS& lmp, double const* position_m) {
  LAMMPS_NS::Domain const& domain = *lmp.domain;
  Vec3 inside(position_m);
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.periodicity[axis]) {
      double const low = domain.boxlo[axis];
      double const period = domain.prd[axis];
      inside[axis] -= period * std::floor((inside[axis] - low) / period);
      if (inside[axis] >= domain.boxhi[axis]) {  // -1e-30 wraps to the upper face
        inside[axis] = low;
      }
    }
  }
  return inside;
}

std::string as_text(Vec3 const& v) {
  char text[96];
  std::snprintf(text, sizeof(text), "%.17g %.17g %.17g", v[0], v[1], v[2]);
  return text;
}

}  // namespace slidewave::dem
