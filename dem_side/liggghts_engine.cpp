#include "liggghts_engine.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "atom.h"
#include "atoms_state.h"
#include "contact_scale.h"
#include "domain.h"
#include "dump.h"
#include "error_route.h"
#include "fix_slidewave.h"
#include "held_atoms.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "output.h"
#include "pair_style.h"
#include "registry.h"
#include "script_scan.h"
#include "slidewave/physics/contact_secant.hpp"
#include "slidewave/screen.hpp"
#include "stock_facts.h"
#include "thermo.h"
#include "update.h"

namespace fs = std::filesystem;
using LAMMPS_NS::FixSlidewave;
using LAMMPS_NS::LAMMPS;

namespace slidewave::dem {
namespace {

Session* guarded_session = nullptr;

void refuse_in_script(char const* command) {
  guarded_session->fail(std::string("the LIGGGHTS script says '") + command +
                            "', but it may only set the scene up (run 0 at most): the coupled run "
                            "advances time itself; prepare states with slidewave_dem --script",
                        2);
}

Feature contact_kernel() {
  OwnPairs const* const pairs = OwnPairs::current();
  return {"contact_kernel", pairs != nullptr,
          pairs ? pairs->name() + ", " + std::to_string(pairs->numbers()) +
                      " numbers of history a contact"
                : "packaged contact law"};
}

bool wants_audit(Scene const& scene) {
  return scene.flag("dem.energy_audit", true);
}

fs::path case_file(Session const& session) {
  return session.scene().directory() / "case.toml";
}

}  // namespace

LiggghtsEngine::LiggghtsEngine(Session& session)
    : session_(session), folder_(fs::absolute(session.scene().directory()) / "dem") {
  Scene const& scene = session.scene();
  fs::path const log = folder_.parent_path() / "log.dem";
  end_s_ = scene.number("case.end_time");
  if (!fs::is_directory(folder_)) {
    throw InputError(case_file(session).string(), "dem", folder_.string(), "no such folder");
  }
  send_screen_to(log, session);
  fs::current_path(folder_);
  guarded_session = &session;
  route_errors(session, log);
  set_up_scene();
  state_facts();
}

LiggghtsEngine::~LiggghtsEngine() {
  quote_script_of(nullptr);
  InsideLiggghts const inside;
  lmp_.reset();
}

void LiggghtsEngine::set_up_scene() {
  Scene const& scene = session_.scene();
  fs::path const script = folder_.parent_path() / scene.text("dem.script");
  if (!fs::is_regular_file(script)) {
    throw InputError(case_file(session_).string(), "dem.script", scene.text("dem.script"),
                     "no such file in " + folder_.parent_path().string());
  }
  ForbiddenCommand const found = find_forbidden(script, folder_);
  if (!found.command.empty()) {
    throw InputError(found.file.string(), "line " + std::to_string(found.line), found.command,
                     found.command == "clear"
                         ? "set the scene up in one go; clear would drop what slidewave added"
                         : "remove it: VTK dumps hang a coupled run, and particles are written to "
                           "dem/particles.vtk.series anyway");
  }
  ContactScaling const scaling = contact_scaling(scene.text("models.contact_scaling", "none"));
  contact_scale() = slidewave::contact_scale(scaling, scene.number("parameters.coarse_grain", 1.0));
  InsideLiggghts const inside;
  char words[][12] = {"slidewave", "-log", "none"};
  char* arguments[] = {words[0], words[1], words[2]};
  lmp_ = std::make_unique<LAMMPS>(3, arguments, session_.comm());
  quote_script_of(lmp_.get());
  register_styles(*lmp_);
  guard_run_commands(*lmp_, refuse_in_script);
  if (fs::is_regular_file(folder_ / "parameters")) {
    lmp_->input->file("parameters");
  }
  lmp_->input->file(script.c_str());
  if (!styles_registered(*lmp_)) {
    session_.fail("the LIGGGHTS script says 'clear', which drops what slidewave added", 2);
  }
  if (!lmp_->domain->box_exist) {
    throw InputError(script.string(), "create_box or read_data", "missing", "give the scene a box");
  }
  quote_script_of(nullptr);
  if (scaling != ContactScaling::none && !OwnPairs::current()) {
    throw InputError(case_file(session_).string(), "models.contact_scaling",
                     scene.text("models.contact_scaling"),
                     "scales model linear only; take that contact law, or none");
  }
  // LIGGGHTS by default lets particles go in silence.
  std::string const lost = "thermo_modify lost " + scene.text("coupling.outside", "error");
  lmp_->input->one(lost.c_str());
  wanted_dt_s_ = scene.number("parameters.dem_dt", lmp_->update->dt);
  loop_ = std::make_unique<StepLoop>(*lmp_);
  ParticleReport::add_columns(seen_);
  report_ = std::make_unique<ParticleReport>(session_);
  if (OwnPairs::current()) {
    step_watch_ = std::make_unique<StepWatch>(*lmp_, session_);
  }
  if (wants_audit(scene) && EnergyAudit::obstacle(*lmp_).empty()) {
    audit_ = std::make_unique<EnergyAudit>(*lmp_, session_.has_partner());
  }
  observe();
}

void LiggghtsEngine::observe() {
  if (report_->wants_particles()) {
    LiggghtsEngine::gather(seen_);  // the constructor observes too
  }
  bool const wanted = report_->wants_overlap(lmp_->update->ntimestep);
  quantities_ = report_->observe(seen_, wanted ? max_overlap(*lmp_) : 0.0);
  if (step_watch_) {
    quantities_.push_back(step_watch_->observe(loop_->dt_s()));
  }
  if (!audit_) {
    return;
  }
  std::vector<Quantity> const energy = audit_->observe();
  quantities_.insert(quantities_.end(), energy.begin(), energy.end());
  double const drift = audit_->drift();
  if (drift > EnergyAudit::limit) {
    session_.fail("the particles gained " + std::to_string(100 * drift) +
                  " % of the energy turned over from nowhere: the particle step is too long for "
                  "their contacts; lower parameters.dem_dt");
  }
  if (std::abs(drift) > EnergyAudit::warning && !drift_told_) {
    drift_told_ = true;
    session_.say("warning: the particles' energy is off by " + std::to_string(100 * drift) +
                 " % of what was turned over (energy_drift in history.csv); a smaller "
                 "parameters.dem_dt mends it");
  }
}

void LiggghtsEngine::state_facts() {
  InsideLiggghts const inside;
  if (auto const g = gravity(*lmp_)) {
    session_.state("gravity", as_text(*g));
  }
  session_.state("boundary", boundaries(*lmp_));
  session_.state("particle_types", std::to_string(lmp_->atom->ntypes));
  HeldAtoms atoms;
  atoms.find(*lmp_);
  if (std::string const axes = atoms.partly_held(*lmp_); !axes.empty()) {
    session_.state("partly_held", axes);
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.17g", end_s_);
  session_.state("end_time", text);
}

Box LiggghtsEngine::bounds() const {
  return sub_domain(*lmp_);
}

std::vector<Feature> LiggghtsEngine::features() const {
  return {{"fluid_kick", session_.has_partner(),
           session_.has_partner() ? "exponential half kicks" : "dry scene"},
          contact_kernel(),
          {"contact_scaling", contact_scale().stiffness != 1,
           "models.contact_scaling = " + session_.scene().text("models.contact_scaling", "none") +
               ", K times " + std::to_string(contact_scale().stiffness)},
          {"energy_audit", audit_ != nullptr,
           audit_                          ? "columns of history.csv"
           : wants_audit(session_.scene()) ? EnergyAudit::obstacle(*lmp_)
                                           : "dem.energy_audit = false"},
          {"checkpoints", passes_state(),
           passes_state() ? "on a signal or [checkpoint]"
                          : "fix " + fix_without_checkpoint(*lmp_) + " keeps state of its own"},
          {"particle_layers", session_.scene().number("output.layers", 0.0) > 0, "output.layers"}};
}

void LiggghtsEngine::gather(Table& particles) {
  LAMMPS_NS::Atom const& atom = *lmp_->atom;
  particles.resize(atom.nlocal);
  auto const fill = [&](char const* name, auto const& value) {
    if (particles.has(name)) {
      Table::Column column = particles[name];
      for (int i = 0; i < atom.nlocal; ++i) {
        value(i, column.col(i));
      }
    }
  };
  auto const copy = [&](char const* name, auto const& first) {  // columns that lie in one piece
    if (atom.nlocal > 0 && particles.has(name)) {
      Table::Column column = particles[name];
      std::copy_n(first(), column.size(), column.data());
    }
  };
  fill("id", [&](int i, auto out) { out[0] = atom.tag[i]; });
  fill("position", [&](int i, auto out) { out = wrapped(*lmp_, atom.x[i]); });
  copy("velocity", [&] { return atom.v[0]; });
  fill("angular_velocity", [&](int i, auto out) { out = Vec3(atom.omega[i]); });
  fill("type", [&](int i, auto out) { out[0] = atom.type[i]; });
  copy("radius", [&] { return atom.radius; });
  copy("mass", [&] { return atom.rmass; });
  for (char const* name : {"impulse", "memory"}) {
    if (!kick_ || !kick_->has(name)) {
      fill(name, [](int, auto out) { out.setZero(); });
    } else if (particles.has(name)) {
      auto const kept = kick_->values(name);
      std::copy_n(kept.first, static_cast<long>(kept.components) * atom.nlocal,
                  particles[name].data());
    }
  }
  if (particles.has("travel")) {
    extras_wanted_ = true;
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
    force.col(i) = Vec3(kick_->other_force(i));
    Vec3 const weight = atom.rmass[i] * g;
    bool const pushed = (force.col(i) - weight).norm() > 1e-9 * weight.norm();  // by a wall, say
    stiffest(0, i) = kick_->held(i) ? held_stiffness
                     : pushed || touching_.touches(i)
                         ? stiffest_contact(atom.rmass[i], loop_->dt_s())
                         : 0;
  }
}

// Columns are known with the first answers only; the fix goes last, to see every other force.
void LiggghtsEngine::add_kick() {
  lmp_->input->one(kick_command_.c_str());
  kick_ = static_cast<FixSlidewave*>(lmp_->modify->find_fix_id("slidewave_kick"));
  if (audit_) {
    audit_->add_fluid();
  }
  if (extras_wanted_) {
    touching_.add(*lmp_);
  }
}

void LiggghtsEngine::apply(Table const& answers) {
  InsideLiggghts const inside;
  LAMMPS_NS::Atom const& atom = *lmp_->atom;
  if (!kick_) {
    kick_command_ = "fix slidewave_kick all slidewave";
    kick_command_ += answers.has("drag") ? " drag 0 fluid_velocity 0 0 0" : "";
    kick_command_ += answers.has("force") ? " force 0 0 0" : "";
    kick_command_ += answers.has("added_mass") ? " added_mass 0" : "";
    kick_command_ += answers.has("exchanged_force") ? " exchanged_force 0 0 0" : "";
    kick_command_ += answers.has("rotational_drag") ? " rotational_drag 0 fluid_spin 0 0 0" : "";
    bool const books = answers.has("drag") || answers.has("exchanged_force");
    kick_command_ += books ? " impulse" : "";
    if (answers.has("memory")) {
      kick_command_ += " memory " + std::to_string(answers["memory"].rows());
    }
    kick_command_ += extras_wanted_ ? " start" : "";
    add_kick();
  }
  for (char const* name : {"drag", "fluid_velocity", "force", "added_mass", "exchanged_force",
                           "rotational_drag", "fluid_spin", "memory"}) {
    if (!answers.has(name)) {
      continue;
    }
    Table::ConstColumn const column = answers[name];
    bool const positive = std::strcmp(name, "drag") == 0;
    // Taken together first, which is cheap: the sum of 0 x is 0, or not a number.
    bool const fine =
        column.size() == 0 || ((0.0 * column).sum() == 0 && !(positive && column.minCoeff() < 0));
    for (int i = 0; i < atom.nlocal && !fine; ++i) {
      if (!column.col(i).allFinite() || (positive && column(0, i) < 0)) {
        session_.fail("particle " + std::to_string(atom.tag[i]) + " received a bad " + name + ": " +
                      std::to_string(column(0, i)));
      }
    }
    std::copy_n(column.data(), column.size(), kick_->values(name).first);
  }
  kick_->begin_window();
}

std::optional<Vec3> LiggghtsEngine::received_impulse() const {
  return kick_ ? std::optional<Vec3>(kick_->received().data()) : std::nullopt;
}

void LiggghtsEngine::advance(Window const& window) {
  InsideLiggghts const inside;
  bool const moves = window.length_s() > 0;
  if (!moves) {
    if (extras_wanted_) {  // the first window wants to know the contacts
      loop_->prepare(session_.scene().number("coupling.window"), wanted_dt_s_, end_s_);
    }
    return;
  }
  report_->picture(seen_, window.index - 1, window.t0_s);  // the initial state, if not there yet
  if (audit_ && !audit_->started()) {
    loop_->prepare(window.length_s(), wanted_dt_s_, end_s_ - window.t0_s);
    audit_->observe();
  }
  loop_->advance(window.length_s(), wanted_dt_s_, end_s_ - window.t0_s);
  check_numbers();
  lmp_->output->thermo->lost_check();
  observe();
  report_->picture(seen_, window.index, window.t1_s);
  if (window.t1_s >= end_s_ * (1 - 1e-9)) {
    loop_->finish();
  }
}

bool LiggghtsEngine::passes_state() const {
  return fix_without_checkpoint(*lmp_).empty();
}

void LiggghtsEngine::pass(State& state) {
  InsideLiggghts const inside;
  state.pass("liggghts.kick", kick_command_);
  state.pass("liggghts.extras", extras_wanted_);
  report_->pass(state);
  if (!state.saving()) {
    append_to_dumps();
    if (!kick_command_.empty()) {
      add_kick();
    }
  }
  loop_->pass(state);
  pass_atoms(*lmp_, state, kick_);
  if (audit_) {
    audit_->pass(state, session_.rank());
  }
}

// A run that goes on must not empty the files that the one before wrote.
void LiggghtsEngine::append_to_dumps() const {
  for (int k = 0; k < lmp_->output->ndump; ++k) {
    std::string const command =
        std::string("dump_modify ") + lmp_->output->dump[k]->id + " append yes";
    lmp_->input->one(command.c_str());
  }
}

void LiggghtsEngine::check_numbers() const {
  LAMMPS_NS::Atom const& atom = *lmp_->atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (!Vec3(atom.x[i]).allFinite() || !Vec3(atom.v[i]).allFinite()) {
      session_.fail("particle " + std::to_string(atom.tag[i]) +
                    " has no position or velocity any more (not a number): the DEM step is too "
                    "large, or the forces on it are");
    }
  }
}

}  // namespace slidewave::dem
