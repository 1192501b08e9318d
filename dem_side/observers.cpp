#include "observers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "atom.h"
#include "force.h"
#include "lammps.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "stock_facts.h"

using LAMMPS_NS::Atom;
using LAMMPS_NS::LAMMPS;

namespace slidewave::dem {
namespace {

void sum_over_ranks(LAMMPS& lmp, double* values, int count) {
  MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, lmp.world);
}

double mean_speed(LAMMPS& lmp) {
  Atom const& atom = *lmp.atom;
  double sums[2] = {0, 0};  // mass, mass times speed
  for (int i = 0; i < atom.nlocal; ++i) {
    sums[0] += atom.rmass[i];
    sums[1] += atom.rmass[i] * Eigen::Map<Vec3 const>(atom.v[i]).norm();
  }
  sum_over_ranks(lmp, sums, 2);
  return sums[0] > 0 ? sums[1] / sums[0] : 0.0;
}

}  // namespace

double kinetic_energy(LAMMPS& lmp) {
  Atom const& atom = *lmp.atom;
  double sum = 0;
  for (int i = 0; i < atom.nlocal; ++i) {
    double const inertia = 0.4 * atom.radius[i] * atom.radius[i];  // of a sphere, per mass
    sum += 0.5 * atom.rmass[i] *
           (Eigen::Map<Vec3 const>(atom.v[i]).squaredNorm() +
            inertia * Eigen::Map<Vec3 const>(atom.omega[i]).squaredNorm());
  }
  sum_over_ranks(lmp, &sum, 1);
  return sum;
}

// Weighs by bins, then refines the bin that holds the front: no sorting, no global list.
double mass_front_x(LAMMPS& lmp, double part) {
  constexpr int bins = 1000;
  Atom const& atom = *lmp.atom;
  double range_m[2] = {1e300, 1e300};  // lowest, and minus the highest
  for (int i = 0; i < atom.nlocal; ++i) {
    range_m[0] = std::min(range_m[0], atom.x[i][0]);
    range_m[1] = std::min(range_m[1], -atom.x[i][0]);
  }
  MPI_Allreduce(MPI_IN_PLACE, range_m, 2, MPI_DOUBLE, MPI_MIN, lmp.world);
  double low = range_m[0];
  double high = -range_m[1];
  if (low > high) {
    return 0.0;  // no particle anywhere
  }
  double below = 0;
  double wanted = -1;
  for (int pass = 0; pass < 2; ++pass) {
    double const width = (high - low) / bins;
    std::array<double, bins> mass{};
    for (int i = 0; i < atom.nlocal; ++i) {
      double const place = width > 0 ? (atom.x[i][0] - low) / width : 0.0;
      bool const last = pass == 0 && place >= bins;
      if (place >= 0 && (place < bins || last)) {
        mass[static_cast<std::size_t>(std::min(place, bins - 1.0))] += atom.rmass[i];
      }
    }
    sum_over_ranks(lmp, mass.data(), bins);
    if (wanted < 0) {
      double all = 0;
      for (double const m : mass) {
        all += m;
      }
      wanted = part * all;
    }
    std::size_t bin = 0;
    while (bin + 1 < bins && below + mass[bin] < wanted) {
      below += mass[bin++];
    }
    low += width * static_cast<double>(bin);
    high = low + width;
  }
  return high;
}

double max_overlap(LAMMPS& lmp) {
  Atom const& atom = *lmp.atom;
  double largest = 0;
  LAMMPS_NS::NeighList const* const list = lmp.force->pair ? lmp.force->pair->list : nullptr;
  if (list && lmp.neighbor->lastcall >= 0) {
    for (int row = 0; row < list->inum; ++row) {
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
  }
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, lmp.world);
  return largest;
}

Observers::Observers(LAMMPS& lmp, Scene const& scene) : lmp_(lmp) {
  if (!scene.has("observe")) {
    return;
  }
  for (std::string const& name : scene.keys("observe")) {
    std::string const table = "observe." + name;
    std::string const type = scene.text(table + ".type");
    slide_ = slide_ || type == "slide";
    if (type == "particle") {
      int const id = static_cast<int>(scene.number(table + ".id"));
      double found = 0;
      for (int i = 0; i < lmp.atom->nlocal; ++i) {
        found += lmp.atom->tag[i] == id ? 1 : 0;
      }
      sum_over_ranks(lmp, &found, 1);
      if (found != 1) {
        throw InputError((scene.directory() / "case.toml").string(), table + ".id",
                         std::to_string(id), "give the id of a particle of the scene");
      }
      particles_.push_back({name, id});
    }
  }
}

std::vector<Quantity> Observers::observe() const {
  std::vector<Quantity> values;
  if (slide_) {
    auto count = static_cast<double>(lmp_.atom->nlocal);
    sum_over_ranks(lmp_, &count, 1);
    values.push_back({"slide_speed_m_s", mean_speed(lmp_)});
    values.push_back({"slide_front_x_m", mass_front_x(lmp_, 0.99)});
    values.push_back({"kinetic_energy_J", kinetic_energy(lmp_)});
    values.push_back({"max_overlap", max_overlap(lmp_)});
    values.push_back({"particles", count});
  }
  for (Particle const& particle : particles_) {
    double numbers[6] = {0, 0, 0, 0, 0, 0};
    for (int i = 0; i < lmp_.atom->nlocal; ++i) {
      if (lmp_.atom->tag[i] == particle.id) {
        Vec3 const x = wrapped(lmp_, lmp_.atom->x[i]);
        std::copy_n(x.data(), 3, numbers);
        std::copy_n(lmp_.atom->v[i], 3, numbers + 3);
      }
    }
    sum_over_ranks(lmp_, numbers, 6);
    char const* const suffixes[6] = {"_x_m", "_y_m", "_z_m", "_vx_m_s", "_vy_m_s", "_vz_m_s"};
    for (std::size_t k = 0; k < 6; ++k) {
      values.push_back({particle.name + suffixes[k], numbers[k]});
    }
  }
  return values;
}

}  // namespace slidewave::dem
