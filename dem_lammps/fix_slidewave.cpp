#include "fix_slidewave.h"

#include <algorithm>
#include <cstring>

#include "atom.h"
#include "error.h"
#include "lammps.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

struct Known {
  char const* name;
  int components;
};
constexpr Known known[FixSlidewave::columns] = {
    {"drag", 1}, {"fluid_velocity", 3}, {"force", 3}, {"impulse", 3}, {"memory", 4}};

}  // namespace

int FixSlidewave::column_of(std::string const& name) {
  for (int k = 0; k < columns; ++k) {
    if (name == known[k].name) {
      return k;
    }
  }
  return -1;
}

int FixSlidewave::components(int column) {
  return known[column].components;
}

FixSlidewave::FixSlidewave(LAMMPS* lammps, int argument_count, char** arguments)
    : Fix(lammps, argument_count, arguments) {
  starts_.fill(-1);
  for (int k = 3; k < argument_count; ++k) {
    int const column = column_of(arguments[k]);
    if (column < 0) {
      error->all(FLERR, std::string("fix slidewave: no column ") + arguments[k]);
    }
    starts_[static_cast<std::size_t>(column)] = width_;
    width_ += components(column);
  }
  if (has(drag) != has(fluid_velocity)) {
    error->all(FLERR, std::string("fix slidewave: drag and fluid_velocity need each other"));
  }
  nevery = 1;
  maxexchange = width_;
  create_attribute = 1;
  FixSlidewave::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
}

FixSlidewave::~FixSlidewave() {
  atom->delete_callback(id, Atom::GROW);
}

int FixSlidewave::setmask() {
  return FixConst::POST_FORCE | FixConst::END_OF_STEP;
}

void FixSlidewave::init() {
  if (!atom->rmass || !atom->radius) {
    error->all(FLERR, std::string("fix slidewave needs atom_style sphere"));
  }
  if (std::strcmp(update->unit_style, "si") != 0) {
    error->all(FLERR, std::string("fix slidewave needs units si"));
  }
  if (std::strncmp(update->integrate_style, "verlet", 6) != 0) {
    error->all(FLERR, std::string("fix slidewave needs run_style verlet"));
  }
}

void FixSlidewave::begin_window(bool running) {
  factors_valid_ = false;
  received_.fill(0);
  for (int i = 0; i < atom->nlocal && has(impulse); ++i) {
    std::fill_n(values(impulse, i), 3, 0.0);
  }
  if (running) {
    kick();
  }
}

void FixSlidewave::setup(int) {
  held_.find(*lmp);
  factors_valid_ = false;
  keep_forces();
  kick();
}

void FixSlidewave::post_force(int) {
  if (neighbor->ago == 0) {
    factors_valid_ = false;  // atoms have moved to other slots
  }
  keep_forces();
  kick();
}

void FixSlidewave::end_of_step() {
  if (update->ntimestep != update->laststep) {
    kick();
  }
}

void FixSlidewave::keep_forces() {
  auto const numbers = 3 * static_cast<std::size_t>(atom->nlocal);
  if (other_force_N_.size() < numbers) {
    other_force_N_.resize(numbers + numbers / 8);
  }
  if (numbers > 0) {
    std::memcpy(other_force_N_.data(), atom->f[0], numbers * sizeof(double));
  }
}

void FixSlidewave::update_factors() {
  factors_.resize(static_cast<std::size_t>(atom->nlocal));
  double const half_dt_s = 0.5 * update->dt;
  for (int i = 0; i < atom->nlocal; ++i) {
    factors_[static_cast<std::size_t>(i)] =
        slidewave::kick_factors(*values(drag, i), atom->rmass[i], half_dt_s);
  }
  factors_valid_ = true;
}

void FixSlidewave::kick() {
  bool const drags = has(drag);
  if (drags && !factors_valid_) {
    update_factors();
  }
  double const half_dt_s = 0.5 * update->dt;
  double const* other = other_force_N_.data();
  for (int i = 0; i < atom->nlocal; ++i, other += 3) {
    double const K = drags ? *values(drag, i) : 0.0;
    double const* const u = drags ? values(fluid_velocity, i) : nullptr;
    double const* const extra = has(force_N) ? values(force_N, i) : nullptr;
    double* const sum = has(impulse) ? values(impulse, i) : nullptr;
    for (int axis = 0; axis < 3; ++axis) {
      double& f = atom->f[i][axis];
      double const v = atom->v[i][axis];
      bool const held = held_.held(atom->mask[i], axis);
      double const all_N = other[axis] + (extra && !held ? extra[axis] : 0.0);
      if (!drags) {
        f = all_N;
        continue;
      }
      double share = K * (u[axis] - v) * half_dt_s;  // what a held one takes
      f = all_N;
      if (!held) {
        slidewave::KickFactors const& factors = factors_[static_cast<std::size_t>(i)];
        f = slidewave::effective_force(factors, K, u[axis], v, all_N);
        share = slidewave::drag_impulse(factors, K, u[axis], v, all_N, atom->rmass[i], half_dt_s);
      }
      received_[static_cast<std::size_t>(axis)] += share;
      if (sum) {
        sum[axis] += share;
      }
    }
  }
}

void FixSlidewave::grow_arrays(int atoms) {
  rows_.resize(static_cast<std::size_t>(atoms) * static_cast<std::size_t>(width_));
}

void FixSlidewave::copy_arrays(int from, int to, int) {
  std::copy_n(row(from), width_, row(to));
}

void FixSlidewave::set_arrays(int i) {
  std::fill_n(row(i), width_, 0.0);
}

int FixSlidewave::pack_exchange(int i, double* buffer) {
  std::copy_n(row(i), width_, buffer);
  return width_;
}

int FixSlidewave::unpack_exchange(int i, double* buffer) {
  std::copy_n(buffer, width_, row(i));
  return width_;
}

double FixSlidewave::memory_usage() {
  return static_cast<double>(sizeof(double) * (rows_.size() + other_force_N_.size()) +
                             sizeof(slidewave::KickFactors) * factors_.size());
}

}  // namespace LAMMPS_NS
