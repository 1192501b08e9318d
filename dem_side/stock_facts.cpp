#include "stock_facts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "atom.h"
#include "domain.h"
#include "expose.h"
#include "fix_gravity.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"

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

double max_overlap(LAMMPS& lmp) {
  LAMMPS_NS::Atom const& atom = *lmp.atom;
  double largest = 0;
  LAMMPS_NS::NeighList const* const list = lmp.force->pair ? lmp.force->pair->list : nullptr;
  bool const listed = list && lmp.neighbor->lastcall >= 0;
  for (int row = 0; listed && row < list->inum; ++row) {
    int const i = list->ilist[row];
    Eigen::Map<Vec3 const> const x_i(atom.x[i]);
    for (int k = 0; k < list->numneigh[i]; ++k) {
      int const j = list->firstneigh[i][k] & NEIGHMASK;
      double const reach = atom.radius[i] + atom.radius[j];
      double const square = (x_i - Eigen::Map<Vec3 const>(atom.x[j])).squaredNorm();
      if (square < reach * reach) {
        double const smaller = 2 * std::min(atom.radius[i], atom.radius[j]);
        largest = std::max(largest, (reach - std::sqrt(square)) / smaller);
      }
    }
  }
  return largest;
}

std::string as_text(Vec3 const& v) {
  char text[96];
  std::snprintf(text, sizeof(text), "%.17g %.17g %.17g", v[0], v[1], v[2]);
  return text;
}

}  // namespace slidewave::dem
