#include "stock_facts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "abstract_mesh.h"
#include "atom.h"
#include "domain.h"
#include "expose.h"
#include "fix_gravity.h"
#include "fix_mesh.h"
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

std::optional<WideMesh> wide_mesh(LAMMPS& lmp) {
  LAMMPS_NS::Domain const& domain = *lmp.domain;
  for (int i = 0; i < lmp.modify->nfix; ++i) {
    auto* const fix = dynamic_cast<LAMMPS_NS::FixMesh*>(lmp.modify->fix[i]);
    if (!fix) {
      continue;
    }
    LAMMPS_NS::AbstractMesh& mesh = *fix->mesh();
    // The upper ends, and the lower ones with their signs turned.
    Eigen::Matrix<double, 6, 1> ends =
        Eigen::Matrix<double, 6, 1>::Constant(std::numeric_limits<double>::lowest());
    for (int element = 0; element < mesh.sizeLocal(); ++element) {
      for (int corner = 0; corner < mesh.numNodes(); ++corner) {
        Vec3 node;
        mesh.node_slow(element, corner, node.data());
        ends.head<3>() = ends.head<3>().cwiseMax(node);
        ends.tail<3>() = ends.tail<3>().cwiseMax(-node);
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, ends.data(), 6, MPI_DOUBLE, MPI_MAX, lmp.world);
    for (int axis = 0; axis < 3; ++axis) {
      double const extent = ends[axis] + ends[axis + 3];
      double const period = domain.prd[axis];
      if (domain.periodicity[axis] && extent > period * (1 + 1e-6)) {  // a file's few digits
        return WideMesh{fix->id, axis, extent, period};
      }
    }
  }
  return std::nullopt;
}

std::string as_text(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", number);
  return text;
}

std::string as_text(Vec3 const& v) {
  char text[96];
  std::snprintf(text, sizeof(text), "%.17g %.17g %.17g", v[0], v[1], v[2]);
  return text;
}

}  // namespace slidewave::dem
