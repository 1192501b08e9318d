#include "esys_engine.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "slidewave/screen.hpp"
#include "world.h"

namespace fs = std::filesystem;

namespace slidewave::esys {
namespace {

/// Lines `variable NAME index VALUE` of dem/parameters.
std::map<std::string, std::string> read_parameters(fs::path const& file) {
  std::map<std::string, std::string> values;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string command, name, style, value;
    if (words >> command >> name >> style >> value && command == "variable") {
      values[name] = value;
    }
  }
  return values;
}

std::string as_text(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.17g", value);
  return text;
}

long steps_in(double window_s, double wanted_dt_s) {
  return std::max(1L, std::lround(std::ceil(window_s / wanted_dt_s - 1e-9)));
}

}  // namespace

EsysEngine::EsysEngine(Session& session) : session_(session) {
  Scene const& scene = session.scene();
  fs::path const folder = fs::absolute(scene.directory());
  fs::path const script = folder / scene.text("dem.script");
  std::string const case_file = (scene.directory() / "case.toml").string();
  if (!fs::is_regular_file(script)) {
    throw InputError(case_file, "dem.script", scene.text("dem.script"),
                     "no such file in " + folder.string());
  }
  if (session.size() != 2) {
    throw InputError(case_file, "ranks_dem", std::to_string(session.size()),
                     "ESyS-Particle takes 2: its master and one worker");
  }
  double const window_s = scene.number("coupling.window");
  wanted_dt_s_ = scene.number("parameters.dem_dt");
  send_screen_to(folder / "log.dem", session);
  fs::current_path(folder / "dem");
  enter_world(session);
  if (session.rank() == 0) {
    auto parameters = read_parameters(folder / "dem/parameters");
    parameters["dem_dt"] =
        as_text(window_s / static_cast<double>(steps_in(window_s, wanted_dt_s_)));
    master_ = std::make_unique<Master>(script, parameters);
    let_workers_leave();
  } else {
    worker_ = std::make_unique<Worker>(session);
  }
  Vec3 gravity = worker_ ? worker_->gravity() : Vec3(Vec3::Zero());
  MPI_Allreduce(MPI_IN_PLACE, gravity.data(), 3, MPI_DOUBLE, MPI_SUM, session.comm());
  session.state("gravity",
                as_text(gravity[0]) + " " + as_text(gravity[1]) + " " + as_text(gravity[2]));
  session.state("end_time", as_text(scene.number("case.end_time")));
  ParticleReport::add_columns(seen_);
  report_ = std::make_unique<ParticleReport>(session);
  look();
}

std::vector<Feature> EsysEngine::features() const {
  bool const wet = session_.has_partner();
  return {{"fluid_kick", wet, wet ? "exponential kicks, a whole step each" : "dry scene"},
          {"particle_layers", session_.scene().number("output.layers", 0.0) > 0, "output.layers"}};
}

void EsysEngine::gather(Table& particles) {
  particles.resize(0);
  if (worker_) {
    worker_->gather(particles);
  }
}

void EsysEngine::apply(Table const& answers) {
  if (worker_) {
    worker_->apply(answers);
  }
}

std::optional<Vec3> EsysEngine::received_impulse() const {
  return worker_ ? worker_->received_impulse() : Vec3(Vec3::Zero());
}

void EsysEngine::advance(Window const& window) {
  if (window.length_s() <= 0) {
    return;
  }
  report_->picture(seen_, window.index - 1, window.t0_s);  // the initial state, if not there yet
  long const steps = steps_in(window.length_s(), wanted_dt_s_);
  steps_ += steps;
  if (master_) {
    master_->run(steps, window.length_s() / static_cast<double>(steps));
    let_workers_leave();
  } else {
    worker_->obey();
  }
  look();
  check_numbers();
  report_->picture(seen_, window.index, window.t1_s);
}

void EsysEngine::look() {
  gather(seen_);
  bool const wanted = report_->wants_overlap(steps_);
  quantities_ = report_->observe(seen_, worker_ && wanted ? worker_->max_overlap() : 0.0);
}

void EsysEngine::check_numbers() const {
  for (long i = 0; i < seen_.size(); ++i) {
    if (!seen_["position"].col(i).allFinite() || !seen_["velocity"].col(i).allFinite()) {
      session_.fail("particle " + std::to_string(std::lround(seen_["id"](0, i))) +
                    " has no position or velocity any more (not a number): the DEM step is too "
                    "large, or the forces on it are");
    }
  }
}

}  // namespace slidewave::esys
