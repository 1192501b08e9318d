#include "fix_slidewave.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "atom.h"
#include "atom_column.h"
#include "domain.h"
#include "error.h"
#include "fix_property_atom.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

std::map<std::string, int> const known_columns = {{"drag", 1},
                                                  {"fluid_velocity", 3},
                                                  {"force", 3},
                                                  {"impulse", 3},
                                                  {"added_mass", 1},
                                                  {"exchanged_force", 3},
                                                  {"rotational_drag", 1},
                                                  {"fluid_spin", 3},
                                                  {"memory", 4},
                                                  {"start", 3}};

/// Where an atom stood that was inserted since begin_window().
constexpr double nowhere_m = 1e300;

bool given_as_numbers(std::string const& column) {
  return column != "impulse" && column != "memory" && column != "start";
}

}  // namespace

FixSlidewave::FixSlidewave(LAMMPS* lammps, int argument_count, char** arguments)
    : Fix(lammps, argument_count, arguments) {
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 1;
  int next = 3;
  while (next < argument_count) {
    std::string const name = arguments[next++];
    auto const known = known_columns.find(name);
    if (known == known_columns.end()) {
      error->fix_error(FLERR, this,
                       "columns are drag, fluid_velocity, force, added_mass, exchanged_force, "
                       "rotational_drag, fluid_spin, impulse, memory, start");
    }
    Column& column = columns_[name];
    column.components = known->second;
    if (name == "memory" && next < argument_count && std::isdigit(arguments[next][0])) {
      column.components = force->inumeric(FLERR, arguments[next++]);
    }
    column.initial.assign(static_cast<std::size_t>(column.components),
                          name == "start" ? nowhere_m : 0.0);
    if (given_as_numbers(name)) {
      if (next + column.components > argument_count) {
        error->fix_error(FLERR, this, "a column lacks its initial values");
      }
      for (double& value : column.initial) {
        value = force->numeric(FLERR, arguments[next++]);
      }
    }
  }
  if (has("drag") != has("fluid_velocity")) {
    error->fix_error(FLERR, this, "drag and fluid_velocity need each other");
  }
  if (has("rotational_drag") != has("fluid_spin")) {
    error->fix_error(FLERR, this, "rotational_drag and fluid_spin need each other");
  }
}

void FixSlidewave::post_create() {
  for (auto& [name, column] : columns_) {
    column.store = slidewave::dem::add_atom_column(*lmp, name, column.initial);
  }
}

void FixSlidewave::pre_delete(bool unfixed) {
  for (auto& [name, column] : columns_) {
    if (unfixed && column.store) {
      modify->delete_fix(column.store->id);
    }
    column.store = nullptr;
  }
}

int FixSlidewave::setmask() {
  return FixConst::PRE_INITIAL_INTEGRATE | FixConst::POST_FORCE;
}

void FixSlidewave::init() {
  if (!atom->rmass) {
    error->fix_error(FLERR, this, "needs atom_style granular (a mass per atom)");
  }
  if (std::strcmp(update->unit_style, "si") != 0) {
    error->fix_error(FLERR, this, "needs units si");
  }
  if (modify->n_fixes_style("multisphere") > 0) {
    error->fix_error(FLERR, this, "fluid forces on multisphere bodies are not supported");
  }
}

double* FixSlidewave::values(std::string const& column, int i) const {
  Column const& found = columns_.at(column);
  return found.components == 1 ? &found.store->vector_atom[i] : found.store->array_atom[i];
}

// LAMMPS keeps a two-dimensional array in one piece.
FixSlidewave::Values FixSlidewave::values(std::string const& column) const {
  return {atom->nlocal > 0 ? values(column, 0) : nullptr, columns_.at(column).components};
}

void FixSlidewave::begin_window() {
  factors_valid_ = false;
  received_.fill(0);
  if (has("impulse")) {
    Values const impulse = values("impulse");
    std::fill_n(impulse.first, 3L * atom->nlocal, 0.0);
  }
  for (int i = 0; i < atom->nlocal && has("start"); ++i) {
    domain->unmap(atom->x[i], atom->image[i], values("start", i));
  }
}

std::array<double, 3> FixSlidewave::travel(int i) const {
  std::array<double, 3> way{};
  if (*values("start", i) >= nowhere_m) {
    return way;
  }
  domain->unmap(atom->x[i], atom->image[i], way.data());
  double const* const start = values("start", i);
  for (unsigned axis = 0; axis < 3; ++axis) {
    way[axis] -= start[axis];
  }
  return way;
}

bool FixSlidewave::held(int i) const {
  int const mask = atom->mask[i];
  return held_.held(mask, 0) && held_.held(mask, 1) && held_.held(mask, 2);
}

void FixSlidewave::setup(int) {
  held_.find(*lmp);
  factors_valid_ = false;
  keep_forces();
}

// The first half kick of a step: positions, and so all forces but the fluid's, are those of the
// last step's end.
void FixSlidewave::pre_initial_integrate() {
  kick();
}

void FixSlidewave::post_force(int) {
  if (neighbor->ago == 0) {
    factors_valid_ = false;  // atoms have moved to other slots
  }
  keep_forces();
  kick();
}

void FixSlidewave::keep_forces() {
  auto const numbers = 3 * static_cast<std::size_t>(atom->nlocal);
  if (other_force_N_.size() < numbers) {
    other_force_N_.resize(numbers + numbers / 8);
  }
  if (numbers > 0) {
    std::memcpy(other_force_N_.data(), atom->f[0], numbers * sizeof(double));
  }
  if (has("rotational_drag")) {
    other_torque_N_m_.resize(std::max(other_torque_N_m_.size(), numbers));
    std::copy_n(numbers > 0 ? atom->torque[0] : nullptr, numbers, other_torque_N_m_.data());
  }
}

double* FixSlidewave::numbers_of(std::string const& column) const {
  return has(column) ? columns_.at(column).store->vector_atom : nullptr;
}

double** FixSlidewave::vectors_of(std::string const& column) const {
  return has(column) ? columns_.at(column).store->array_atom : nullptr;
}

void FixSlidewave::update_factors() {
  auto const count = static_cast<std::size_t>(atom->nlocal);
  factors_.resize(count);
  double const half_dt_s = 0.5 * update->dt;
  double const* const drag = numbers_of("drag");
  double const* const added = numbers_of("added_mass");
  for (std::size_t i = 0; i < count; ++i) {
    factors_[i] = slidewave::kick_factors(drag ? drag[i] : 0.0,
                                          atom->rmass[i] + (added ? added[i] : 0.0), half_dt_s);
  }
  if (double const* const turned = numbers_of("rotational_drag")) {
    turn_factors_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      turn_factors_[i] = slidewave::kick_factors(turned[i], inertia_kg_m2(i), half_dt_s);
    }
  }
  factors_valid_ = true;
}

void FixSlidewave::turn() {
  double const* const drag = numbers_of("rotational_drag");
  double* const* const spin = vectors_of("fluid_spin");
  double const* other = other_torque_N_m_.data();
  for (int i = 0; i < atom->nlocal; ++i) {
    bool const fixed = held(i);
    for (int axis = 0; axis < 3; ++axis, ++other) {
      atom->torque[i][axis] =
          fixed ? *other
                : slidewave::effective_force(turn_factors_[static_cast<std::size_t>(i)], drag[i],
                                             spin[i][axis], atom->omega[i][axis], *other);
    }
  }
}

void FixSlidewave::kick() {
  KickColumns const columns{
      numbers_of("drag"),  vectors_of("fluid_velocity"),  numbers_of("added_mass"),
      vectors_of("force"), vectors_of("exchanged_force"), vectors_of("impulse")};
  bool const plain = !columns.drag && !columns.added && !columns.exchanged;
  bool const turns = has("rotational_drag");
  if ((!plain || turns) && !factors_valid_) {
    update_factors();
  }
  if (turns) {
    turn();
  }
  bool const usual =
      columns.drag && columns.extra && columns.impulse && !columns.added && !columns.exchanged;
  if (usual && atom->nlocal > 0) {
    kick_usual(columns);
    return;
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    kick_any(i, columns, received_);
  }
}

// Drag and a force, on free atoms without a branch: this runs twice a step, and waits for memory.
void FixSlidewave::kick_usual(KickColumns const& columns) {
  double const half_dt_s = 0.5 * update->dt;
  double const *u = columns.fluid[0], *extra_N = columns.extra[0], *v = atom->v[0],
               *other_N = other_force_N_.data();
  double *f = atom->f[0], *booked = columns.impulse[0];
  std::array<double, 3> received = received_;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!held_.free(atom->mask[i])) {
      kick_any(i, columns, received);
      u += 3, extra_N += 3, v += 3, other_N += 3, f += 3, booked += 3;
      continue;
    }
    slidewave::KickFactors const factors = factors_[static_cast<std::size_t>(i)];
    double const drag_kg_s = columns.drag[i];
    double const response_s_kg = slidewave::mean_response(factors, atom->rmass[i], half_dt_s);
    for (double& all : received) {
      double const all_N = *other_N++ + *extra_N++;
      double const share = slidewave::drag_impulse_of_response(factors, response_s_kg, drag_kg_s,
                                                               *u, *v, all_N, half_dt_s);
      *f++ = slidewave::effective_force(factors, drag_kg_s, *u++, *v++, all_N);
      *booked++ += share;
      all += share;
    }
  }
  received_ = received;
}

void FixSlidewave::kick_any(int i, KickColumns const& columns, std::array<double, 3>& received) {
  std::array<double, 3> const none{};
  std::array<double, 3> unkept{};
  double const half_dt_s = 0.5 * update->dt;
  double const* const u = columns.fluid ? columns.fluid[i] : none.data();
  double const* const extra_N = columns.extra ? columns.extra[i] : none.data();
  double const* const given_N = columns.exchanged ? columns.exchanged[i] : none.data();
  double const *const v = atom->v[i], *const other = other_force_N(i);
  double* const booked = columns.impulse ? columns.impulse[i] : unkept.data();
  double* const f = atom->f[i];
  bool const plain = !columns.drag && !columns.added && !columns.exchanged;
  slidewave::KickFactors const factors =
      plain ? slidewave::KickFactors() : factors_[static_cast<std::size_t>(i)];
  double const drag_kg_s = columns.drag ? columns.drag[i] : 0.0,
               added_kg = columns.added ? columns.added[i] : 0.0,
               mass_kg = atom->rmass[i] + added_kg;
  double const response_s_kg = slidewave::mean_response(factors, mass_kg, half_dt_s);
  double const own_share = columns.added ? atom->rmass[i] / mass_kg : 1.0,
               added_share = columns.added ? added_kg / mass_kg : 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    double share = 0;
    if (held_.held(atom->mask[i], axis)) {
      f[axis] = other[axis];
      share = (drag_kg_s * (u[axis] - v[axis]) + given_N[axis]) * half_dt_s;
    } else {
      double const all_N = other[axis] + extra_N[axis] + given_N[axis];
      double const moves_N =
          slidewave::effective_force(factors, drag_kg_s, u[axis], v[axis], all_N);
      f[axis] = moves_N * own_share;
      share = slidewave::drag_impulse_of_response(factors, response_s_kg, drag_kg_s, u[axis],
                                                  v[axis], all_N, half_dt_s) +
              (given_N[axis] - moves_N * added_share) * half_dt_s;
    }
    received[static_cast<unsigned>(axis)] += share;
    booked[axis] += share;
  }
}

double FixSlidewave::compute_vector(int axis) {
  double sum = 0;
  if (has("impulse")) {
    for (int i = 0; i < atom->nlocal; ++i) {
      sum += values("impulse", i)[axis];
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum;
}

}  // namespace LAMMPS_NS
