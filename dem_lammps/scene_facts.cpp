#include "scene_facts.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "domain.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair.h"
#include "registry.h"

using LAMMPS_NS::LAMMPS;

namespace slidewave::lammps {

std::optional<Vec3> gravity(LAMMPS& lmp) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < lmp.modify->nfix; ++i) {
    LAMMPS_NS::Fix& fix = *lmp.modify->fix[i];
    if (std::string(fix.style) != "gravity") {
      continue;
    }
    for (std::string const& word : words_of_fix(fix.id)) {
      if (word.rfind("v_", 0) == 0) {
        return std::nullopt;
      }
    }
    fix.init();  // works the direction out
    int dimension = 0;
    if (auto const* const g = static_cast<double const*>(fix.extract("gvec", dimension))) {
      sum += Eigen::Map<Vec3 const>(g);
    }
  }
  return sum;
}

std::string boundaries(LAMMPS const& lmp) {
  std::string text;
  for (int const periodic : lmp.domain->periodicity) {
    text += periodic ? "p" : "b";
  }
  return text;
}

Box sub_domain(LAMMPS const& lmp) {
  return {Vec3(lmp.domain->sublo), Vec3(lmp.domain->subhi)};
}

Vec3 wrapped(LAMMPS const& lmp, double const* position_m) {
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

double max_overlap(LAMMPS const& lmp) {
  LAMMPS_NS::Atom const& atom = *lmp.atom;
  LAMMPS_NS::NeighList const* const list = lmp.force->pair ? lmp.force->pair->list : nullptr;
  double largest = 0;
  for (int row = 0; list && row < list->inum; ++row) {
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

}  // namespace slidewave::lammps
