// What crosses the coupling: the engine's own arrays are lent where their layout allows, since
// copying them would cost more than what is done with them.
#include "atom.h"
#include "atoms_gather.h"
#include "error_route.h"
#include "fix_slidewave.h"
#include "input.h"
#include "lammps.h"
#include "liggghts_engine.h"
#include "modify.h"
#include "slidewave/physics/contact_secant.hpp"
#include "stock_facts.h"

using LAMMPS_NS::FixSlidewave;

namespace slidewave::dem {

// The fix goes last, to see every other force.
void LiggghtsEngine::expect(Table const& particles, Table const& answers) {
  if (!session_.has_partner()) {  // a dry scene
    return;
  }
  InsideLiggghts const inside;
  extras_wanted_ = particles.has("travel");
  std::string command = "fix slidewave_kick all slidewave";
  command += answers.has("drag") ? " drag 0 fluid_velocity 0 0 0" : "";
  command += answers.has("force") ? " force 0 0 0" : "";
  command += answers.has("added_mass") ? " added_mass 0" : "";
  command += answers.has("exchanged_force") ? " exchanged_force 0 0 0" : "";
  command += answers.has("rotational_drag") ? " rotational_drag 0 fluid_spin 0 0 0" : "";
  bool const books = answers.has("drag") || answers.has("exchanged_force");
  command += books ? " impulse" : "";
  command += " memory " + std::to_string(answers["memory"].rows());
  command += extras_wanted_ ? " start" : "";
  lmp_->input->one(command.c_str());
  kick_ = static_cast<FixSlidewave*>(lmp_->modify->find_fix_id("slidewave_kick"));
  if (audit_) {
    audit_->add_fluid();
  }
  if (extras_wanted_) {
    touching_.add(*lmp_);
  }
}

void LiggghtsEngine::gather(Table& particles) {
  LAMMPS_NS::Atom const& atom = *lmp_->atom;
  particles.resize(atom.nlocal);
  auto const lend = [&](char const* name, double* values) {
    if (particles.has(name)) {
      particles.lend(name, values);
    }
  };
  bool const some = atom.nlocal > 0;
  if (is_periodic(*lmp_)) {
    gather_positions(*lmp_, particles["position"]);
  } else {
    lend("position", some ? atom.x[0] : nullptr);
  }
  lend("velocity", some ? atom.v[0] : nullptr);
  lend("radius", atom.radius);
  lend("mass", atom.rmass);
  for (char const* name : {"impulse", "memory"}) {
    if (kick_ && kick_->has(name)) {
      lend(name, kick_->values(name).first);
    }
  }
  if (particles.has("type")) {
    auto type = particles["type"];
    for (int i = 0; i < atom.nlocal; ++i) {
      type(0, i) = atom.type[i];
    }
  }
  if (extras_wanted_) {
    gather_extras(particles);
  }
}

// Before the first set-up nothing is known of forces and contacts, and the window has no length.
void LiggghtsEngine::gather_extras(Table& particles) {
  InsideLiggghts const inside;
  bool const known = loop_->running();
  if (known) {
    touching_.count();
  }
  LAMMPS_NS::Atom const& atom = *lmp_->atom;
  auto travel = particles["travel"], force = particles["other_force"],
       stiffest = particles["stiffest"];
  Vec3 const g = gravity(*lmp_).value_or(Vec3::Zero());
  for (int i = 0; i < atom.nlocal; ++i) {
    if (!known) {
      travel.col(i).setZero();
      force.col(i).setZero();
      stiffest(0, i) = 0;
      continue;
    }
    travel.col(i) = Vec3(kick_->travel(i).data());
    force.col(i) = Vec3(kick_->other_force_N(i));
    Vec3 const weight = atom.rmass[i] * g;
    bool const pushed = (force.col(i) - weight).norm() > 1e-9 * weight.norm();  // by a wall, say
    stiffest(0, i) = kick_->held(i) ? held_stiffness
                     : pushed || touching_.touches(i)
                         ? stiffest_contact(atom.rmass[i], loop_->dt_s())
                         : 0;
  }
}

void LiggghtsEngine::offer(Table& answers) {
  for (Field const& field : answers.fields()) {
    answers.lend(field.name, kick_->values(field.name).first);
  }
}

void LiggghtsEngine::apply(Table const& answers) {
  InsideLiggghts const inside;
  if (answers.has("drag") && answers.size() > 0) {  // the coupler saw that all are numbers
    long worst = 0;
    double const least = answers["drag"].row(0).minCoeff(&worst);
    if (least < 0) {
      session_.fail("particle " + std::to_string(lmp_->atom->tag[worst]) +
                    " received a bad drag: " + std::to_string(least));
    }
  }
  kick_->begin_window();
}

}  // namespace slidewave::dem
