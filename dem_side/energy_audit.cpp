#include "energy_audit.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "atom.h"
#include "domain.h"
#include "fix_fluid_work.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "pair_style.h"
#include "stock_facts.h"

namespace slidewave::dem {

std::string EnergyAudit::obstacle(LAMMPS_NS::LAMMPS& lmp) {
  if (!OwnPairs::current()) {
    return "packaged contact law";
  }
  if (!gravity(lmp)) {
    return "gravity varies";
  }
  bool turns = false;
  for (int k = 0; k < lmp.modify->nfix; ++k) {
    std::string const style = lmp.modify->fix[k]->style;
    auto const begins = [&](char const* word) { return style.rfind(word, 0) == 0; };
    turns = turns || style == "nve/sphere";
    bool const counted = begins("slidewave") || begins("gravity") || begins("wall/gran") ||
                         begins("mesh/surface") || begins("neighlist") ||
                         begins("contacthistory") || begins("property/") || style == "nve/sphere";
    bool const acts = lmp.modify->fmask[k] &
                      (LAMMPS_NS::FixConst::POST_FORCE | LAMMPS_NS::FixConst::INITIAL_INTEGRATE);
    if (acts && !counted) {
      return "nobody counts the work of fix " + style;
    }
  }
  return turns ? "" : "spheres do not turn: no fix nve/sphere";
}

void EnergyAudit::add_fluid() {
  char id[] = "slidewave_work";
  char group[] = "all";
  char style[] = "slidewave/work";
  char* arguments[] = {id, group, style};
  lmp_.modify->add_fix(3, arguments);
  fluid_ = static_cast<LAMMPS_NS::FixFluidWork*>(lmp_.modify->find_fix_id(id));
}

EnergyAudit::Books EnergyAudit::add_up() const {
  LAMMPS_NS::Atom const& atom = *lmp_.atom;
  Books books;
  books.particles = atom.nlocal;
  Vec3 const g = gravity(lmp_).value_or(Vec3::Zero());
  for (int i = 0; i < atom.nlocal; ++i) {
    double const mass_kg = atom.rmass[i];
    double const r_m = atom.radius[i];
    Vec3 x;  // periodic images undone: gravity may act along a periodic direction
    lmp_.domain->unmap(atom.x[i], atom.image[i], x.data());
    books.translation += 0.5 * mass_kg * Eigen::Map<Vec3 const>(atom.v[i]).squaredNorm();
    books.rotation +=
        0.2 * mass_kg * r_m * r_m * Eigen::Map<Vec3 const>(atom.omega[i]).squaredNorm();
    books.gravity -= mass_kg * g.dot(x);
  }
  OwnPairs const& pairs = *OwnPairs::current();
  WallBooks const& walls = wall_books();
  Elastic const springs = pairs.elastic();
  books.normal = springs.normal + walls.now.normal;
  books.tangential = springs.tangential + walls.now.tangential;
  books.rolling = springs.rolling + walls.now.rolling;
  books.friction_heat =
      pairs.dissipated().friction + walls.stored.tangential - walls.now.tangential;
  books.damping_heat = pairs.dissipated().damping + walls.damping;
  books.rolling_heat = pairs.dissipated().rolling + walls.stored.rolling - walls.now.rolling;
  books.fluid_work = fluid_ ? fluid_->work_J() : 0.0;
  books.wall_work = walls.work;
  static_assert(sizeof(Books) % sizeof(double) == 0, "a row of numbers");
  MPI_Allreduce(MPI_IN_PLACE, &books, sizeof(Books) / sizeof(double), MPI_DOUBLE, MPI_SUM,
                lmp_.world);
  return books;
}

void EnergyAudit::close(Books const& books) {
  double const now_J = books.stored() + books.gravity + books.heat() - books.work();
  if (!started_) {
    start_J_ = now_J;
    particles_ = books.particles;
    started_ = true;
  }
  if (books.particles != particles_) {  // some came or went: what they carried is not drift
    start_J_ = now_J - drift_ * most_J_;
    particles_ = books.particles;
  }
  most_J_ = std::max(most_J_, books.stored() + books.heat() + std::abs(books.fluid_work) +
                                  std::abs(books.wall_work));
  drift_ = most_J_ > 0 ? (now_J - start_J_) / most_J_ : 0.0;
}

void EnergyAudit::pass(State& state, int rank) {
  Dissipated& lost = *OwnPairs::lost();
  WallBooks& walls = wall_books();
  double work_J = fluid_ ? fluid_->work_J() : 0.0;
  for (auto const& [name, value] : {std::pair("pairs.friction_J", &lost.friction),
                                    {"pairs.damping_J", &lost.damping},
                                    {"pairs.rolling_J", &lost.rolling},
                                    {"walls.normal_J", &walls.stored.normal},
                                    {"walls.tangential_J", &walls.stored.tangential},
                                    {"walls.rolling_J", &walls.stored.rolling},
                                    {"walls.damping_J", &walls.damping},
                                    {"walls.work_J", &walls.work},
                                    {"fluid.work_J", &work_J}}) {
    state.pass_share(std::string("audit.") + name, value, 1, rank);
  }
  if (fluid_) {
    fluid_->set_work(work_J);
  }
  state.pass("audit.started", started_);
  state.pass("audit.start", reinterpret_cast<double*>(&start_), sizeof(Books) / sizeof(double));
  state.pass("audit.particles", particles_);
  state.pass("audit.start_J", start_J_);
  state.pass("audit.most_J", most_J_);
  state.pass("audit.drift", drift_);
}

std::vector<Quantity> EnergyAudit::observe() {
  bool const known = OwnPairs::current()->ready();
  Books books;
  if (known) {
    books = add_up();
    if (!started_) {
      start_ = books;
    }
    books.gravity -= start_.gravity;
    books.friction_heat -= start_.friction_heat;
    books.damping_heat -= start_.damping_heat;
    books.rolling_heat -= start_.rolling_heat;
    books.fluid_work -= start_.fluid_work;
    books.wall_work -= start_.wall_work;
    close(books);
  }
  std::vector<Quantity> values;
  auto const add = [&](char const* name, double value) {
    values.push_back({name, known ? value : std::numeric_limits<double>::quiet_NaN()});
  };
  std::string const kernel = OwnPairs::current()->name();
  bool const rolls =
      kernel.find("jiang") != std::string::npos || kernel.find("iwashita") != std::string::npos;
  add("energy_translation_J", books.translation);
  add("energy_rotation_J", books.rotation);
  add("energy_normal_J", books.normal);
  add("energy_tangential_J", books.tangential);
  if (rolls) {
    add("energy_rolling_J", books.rolling);
  }
  add("energy_gravity_J", books.gravity);
  add("heat_friction_J", books.friction_heat);
  add("heat_damping_J", books.damping_heat);
  if (rolls) {
    add("heat_rolling_J", books.rolling_heat);
  }
  if (with_fluid_) {
    add("work_fluid_J", books.fluid_work);
  }
  add("work_walls_J", books.wall_work);
  add("energy_drift", drift_);
  return values;
}

}  // namespace slidewave::dem
