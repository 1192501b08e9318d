#include <csignal>
#include <string>
#include <vector>

#include "FoamCase.H"
#include "IFstream.H"
#include "dimensionedTypes.H"

namespace slidewave::foam {
namespace {

using namespace Foam;

// OpenFOAM's handlers would take the signals that the session listens to.
struct KeepSignals {
  static constexpr int kept[] = {SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGFPE};
  struct sigaction before[5];
  KeepSignals() {
    for (int i = 0; i < 5; ++i) sigaction(kept[i], nullptr, &before[i]);
  }
  ~KeepSignals() {
    for (int i = 0; i < 5; ++i) sigaction(kept[i], &before[i], nullptr);
  }
};

std::unique_ptr<argList> parseArguments(std::filesystem::path const& directory, bool parallel) {
  std::vector<std::string> words{"slidewave_foam", "-case", directory.string()};
  if (parallel) words.push_back("-parallel");
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int count = static_cast<int>(words.size());
  char** values = pointers.data();
  argList::noFunctionObjects();
  auto args = std::make_unique<argList>(count, values);
  if (!args->checkRootCase()) {
    FatalErrorInFunction << "no OpenFOAM case in " << directory.string() << exit(FatalError);
  }
  return args;
}

std::unique_ptr<Time> openTime(argList const& args, double end_time_s) {
  fileName const file = args.globalPath() / "system" / "controlDict";
  IFstream stream(file);
  dictionary controls(stream);
  if (!controls.found("deltaT")) {
    FatalErrorInFunction << "cannot read " << file << exit(FatalError);
  }
  controls.set("startFrom", "startTime");
  controls.set("stopAt", "endTime");
  controls.set("endTime", end_time_s);
  controls.set("writeControl", "none");
  controls.set("runTimeModifiable", false);
  if (!controls.found("startTime")) controls.add("startTime", 0.0);
  return std::make_unique<Time>(controls, args.rootPath(), args.caseName(), "system", "constant",
                                controls.found("functions"));
}

}  // namespace

FoamCase::FoamCase(std::filesystem::path const& directory, bool parallel, double end_time_s) {
  KeepSignals const keep;
  args_ = parseArguments(directory, parallel);
  time_ = openTime(*args_, end_time_s);
  mesh_ = std::make_unique<fvMesh>(
      IOobject(fvMesh::defaultRegion, time_->timeName(), *time_, IOobject::MUST_READ));
}

void FoamCase::pass(State& state) {
  double now_s = time_->value(), step_s = time_->deltaTValue();
  long step = time_->timeIndex();
  state.pass("time.now_s", now_s);
  state.pass("time.step_s", step_s);
  state.pass("time.step", step);
  if (state.saving()) return;
  time_->setTime(now_s, static_cast<label>(step));
  time_->setDeltaT(step_s, false);
}

uniformDimensionedVectorField readGravity(fvMesh const& mesh) {
  return {IOobject("g", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT),
          dimensionedVector("g", dimAcceleration, Zero)};
}

void refuseUnsupported(fvMesh const& mesh) {
  auto const present = [&](word const& folder, word const& name) {
    return IOobject(name, folder, mesh, IOobject::MUST_READ).typeHeaderOk<IOdictionary>(false);
  };
  Time const& time = mesh.time();
  for (word const& name : {word("fvOptions"), word("MRFProperties"), word("dynamicMeshDict")}) {
    if (present(time.constant(), name) || present(time.system(), name)) {
      FatalErrorInFunction << name << " is not supported here: remove the file" << exit(FatalError);
    }
  }
  if (present(time.constant(), "turbulenceProperties")) {
    IOdictionary const turbulence(
        IOobject("turbulenceProperties", time.constant(), mesh, IOobject::MUST_READ));
    word const type(turbulence.get<word>("simulationType"));
    if (type != "laminar" || turbulence.found("laminar")) {
      FatalErrorInFunction << "turbulenceProperties: only simulationType laminar, without a model: "
                           << "none has a form for flow in pores yet" << exit(FatalError);
    }
  }
  word const ddt(mesh.ddtScheme("ddt(rho,U)"));
  word const ddtAlpha(mesh.ddtScheme("ddt(alpha)"));
  if (ddt != "Euler" || ddtAlpha != "Euler") {
    FatalErrorInFunction << "fvSchemes: ddtSchemes must be Euler" << exit(FatalError);
  }
}

}  // namespace slidewave::foam
