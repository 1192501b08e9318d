#include "liggghts_engine.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "atom.h"
#include "atoms_gather.h"
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
#include "slidewave/screen.hpp"
#include "stock_facts.h"
#include "thermo.h"
#include "update.h"

namespace fs = std::filesystem;
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
  if (auto const wide = wide_mesh(*lmp_)) {
    throw InputError(script.string(), "fix " + wide->name,
                     as_text(wide->extent_m) + " m along " + "xyz"[wide->axis],
                     "longer than the period of " + as_text(wide->period_m) +
                         " m: where its images overlap, contacts count twice; cut the mesh at "
                         "the periodic faces");
  }
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
    gather_atoms(*lmp_, seen_);
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
  report_->pass(state);
  if (!state.saving()) {
    append_to_dumps();
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
