#include "lammps_engine.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "atom.h"
#include "domain.h"
#include "error_route.h"
#include "fix_slidewave.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "registry.h"
#include "scene_facts.h"
#include "slidewave/screen.hpp"
#include "update.h"

namespace fs = std::filesystem;
using LAMMPS_NS::FixSlidewave;
using LAMMPS_NS::LAMMPS;

namespace slidewave::lammps {
namespace {

Session* guarded_session = nullptr;

void refuse_in_script(char const* command) {
  guarded_session->fail(std::string("the LAMMPS script says '") + command +
                            "', but it may only set the scene up (run 0 at most): the coupled run "
                            "advances time itself",
                        2);
}

std::string as_text(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.17g", value);
  return text;
}

}  // namespace

LammpsEngine::LammpsEngine(Session& session)
    : session_(session), folder_(fs::absolute(session.scene().directory()) / "dem") {
  fs::path const case_file = session.scene().directory() / "case.toml";
  fs::path const log = folder_.parent_path() / "log.dem";
  std::string const script = session.scene().text("dem.script");
  if (!fs::is_regular_file(folder_.parent_path() / script)) {
    throw InputError(case_file.string(), "dem.script", script,
                     "no such file in " + folder_.parent_path().string());
  }
  send_screen_to(log, session);
  fs::current_path(folder_);
  guarded_session = &session;
  route_errors(session, log);
  set_up_scene();
  state_facts();
  look();
}

LammpsEngine::~LammpsEngine() {
  InsideLammps const inside;
  lmp_.reset();
}

void LammpsEngine::set_up_scene() {
  Scene const& scene = session_.scene();
  fs::path const script = folder_.parent_path() / scene.text("dem.script");
  InsideLammps const inside;
  std::string words[] = {"slidewave", "-log", "none", "-nocite"};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data()};
  lmp_ = std::make_unique<LAMMPS>(4, arguments, session_.comm());
  register_styles(*lmp_);
  guard_run_commands(*lmp_, refuse_in_script);
  if (fs::is_regular_file(folder_ / "parameters")) {
    lmp_->input->file("parameters");
  }
  lmp_->input->file(script.c_str());
  if (!styles_registered(*lmp_)) {
    throw InputError(script.string(), "clear", "",
                     "set the scene up in one go; clear drops what slidewave added");
  }
  if (!lmp_->domain->box_exist) {
    throw InputError(script.string(), "create_box or read_data", "missing", "give the scene a box");
  }
  if (!lmp_->atom->rmass || !lmp_->atom->radius) {
    throw InputError(script.string(), "atom_style", lmp_->atom->atom_style,
                     "use atom_style sphere: particles need a radius and a mass each");
  }
  allow_run_commands();
  lmp_->input->one("thermo_modify lost " + scene.text("coupling.outside", "error"));
  wanted_dt_s_ = scene.number("parameters.dem_dt", lmp_->update->dt);
  ParticleReport::add_columns(seen_);
  report_ = std::make_unique<ParticleReport>(session_);
}

void LammpsEngine::state_facts() {
  InsideLammps const inside;
  if (auto const g = gravity(*lmp_)) {
    session_.state("gravity", as_text((*g)[0]) + " " + as_text((*g)[1]) + " " + as_text((*g)[2]));
  }
  session_.state("boundary", boundaries(*lmp_));
  session_.state("particle_types", std::to_string(lmp_->atom->ntypes));
  session_.state("end_time", as_text(session_.scene().number("case.end_time")));
}

Box LammpsEngine::bounds() const {
  return sub_domain(*lmp_);
}

std::vector<Feature> LammpsEngine::features() const {
  bool const wet = session_.has_partner();
  return {{"fluid_kick", wet, wet ? "exponential half kicks" : "dry scene"},
          {"particle_layers", session_.scene().number("output.layers", 0.0) > 0, "output.layers"}};
}

void LammpsEngine::gather(Table& particles) {
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
  fill("type", [&](int i, auto out) { out[0] = atom.type[i]; });
  fill("id", [&](int i, auto out) { out[0] = atom.tag[i]; });
  fill("position", [&](int i, auto out) { out = wrapped(*lmp_, atom.x[i]); });
  fill("velocity", [&](int i, auto out) { out = Vec3(atom.v[i]); });
  fill("angular_velocity", [&](int i, auto out) { out = Vec3(atom.omega[i]); });
  fill("radius", [&](int i, auto out) { out[0] = atom.radius[i]; });
  fill("mass", [&](int i, auto out) { out[0] = atom.rmass[i]; });
  for (char const* name : {"impulse", "memory"}) {
    int const column = FixSlidewave::column_of(name);
    bool const kept = kick_ && kick_->has(column);
    fill(name, [&](int i, auto out) {
      for (long k = 0; k < out.rows(); ++k) {
        out[k] = kept ? kick_->values(column, i)[k] : 0.0;
      }
    });
  }
}

// Columns are known with the first answers only; the fix goes last, to see every other force.
void LammpsEngine::add_kick(Table const& answers) {
  std::string command = "fix slidewave_kick all slidewave";
  command += answers.has("drag") ? " drag fluid_velocity impulse" : "";
  command += answers.has("force") ? " force" : "";
  command += answers.has("memory") ? " memory" : "";
  lmp_->input->one(command);
  int const index = lmp_->modify->find_fix("slidewave_kick");
  kick_ = dynamic_cast<FixSlidewave*>(lmp_->modify->fix[index]);
  for (int i = 0; i < lmp_->atom->nlocal; ++i) {
    kick_->set_arrays(i);
  }
}

void LammpsEngine::apply(Table const& answers) {
  InsideLammps const inside;
  LAMMPS_NS::Atom const& atom = *lmp_->atom;
  if (!kick_) {
    add_kick(answers);
  }
  for (char const* name : {"drag", "fluid_velocity", "force", "memory"}) {
    if (!answers.has(name)) {
      continue;
    }
    int const own = FixSlidewave::column_of(name);
    Table::ConstColumn const column = answers[name];
    for (int i = 0; i < atom.nlocal; ++i) {
      if (!column.col(i).allFinite() || (own == FixSlidewave::drag && column(0, i) < 0)) {
        session_.fail("particle " + std::to_string(atom.tag[i]) + " received a bad " + name + ": " +
                      std::to_string(column(0, i)));
      }
      for (long k = 0; k < column.rows(); ++k) {
        kick_->values(own, i)[k] = column(k, i);
      }
    }
  }
}

std::optional<Vec3> LammpsEngine::received_impulse() const {
  return kick_ ? std::optional<Vec3>(kick_->received().data()) : std::nullopt;
}

void LammpsEngine::advance(Window const& window) {
  InsideLammps const inside;
  if (window.length_s() > 0) {
    report_->picture(seen_, window.index - 1, window.t0_s);  // the initial state, if not there yet
    run_steps(window.length_s());
    check_particles();
    look();
    report_->picture(seen_, window.index, window.t1_s);
  } else if (kick_) {
    kick_->begin_window(false);
  }
}

void LammpsEngine::run_steps(double window_s) {
  long const steps = std::max(1L, std::lround(std::ceil(window_s / wanted_dt_s_ - 1e-9)));
  double const dt_s = window_s / static_cast<double>(steps);
  if (std::abs(dt_s - dt_s_) > 1e-9 * dt_s) {  // windows t1 - t0 differ by round-off
    lmp_->input->one("timestep " + as_text(dt_s));
    dt_s_ = dt_s;
  }
  if (kick_) {
    kick_->begin_window(running_);
  }
  lmp_->input->one("run " + std::to_string(steps) + (running_ ? " pre no" : "") + " post no");
  running_ = true;
}

void LammpsEngine::check_particles() {
  LAMMPS_NS::Atom const& atom = *lmp_->atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (!Vec3(atom.x[i]).allFinite() || !Vec3(atom.v[i]).allFinite()) {
      session_.fail("particle " + std::to_string(atom.tag[i]) +
                    " has no position or velocity any more (not a number): the DEM step is too "
                    "large, or the forces on it are");
    }
  }
  long left = atom.nlocal;
  MPI_Allreduce(MPI_IN_PLACE, &left, 1, MPI_LONG, MPI_SUM, session_.comm());
  if (left < atom.natoms && session_.scene().text("coupling.outside", "error") == "error") {
    session_.fail("Lost atoms: " + std::to_string(atom.natoms - left) + " of " +
                  std::to_string(atom.natoms) +
                  " particles left the box of the script (boundary f); enlarge it, or set "
                  "coupling.outside");
  }
}

void LammpsEngine::look() {
  if (report_->wants_particles()) {
    gather(seen_);
  }
  bool const wanted = report_->wants_overlap(lmp_->update->ntimestep);
  bool const listed = running_ && wanted;  // no neighbour list before a run
  quantities_ = report_->observe(seen_, listed ? max_overlap(*lmp_) : 0.0);
}

}  // namespace slidewave::lammps
