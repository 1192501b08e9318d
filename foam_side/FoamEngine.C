#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "DragShares.H"
#include "FieldSampler.H"
#include "FieldState.H"
#include "FoamCase.H"
#include "FoamEngine.H"
#include "Locator.H"
#include "Observer.H"
#include "ParticleKernel.H"
#include "PorousFlow.H"
#include "SolidFraction.H"
#include "World.H"
#include "cyclicPolyPatch.H"
#include "graphOfMesh.H"
#include "labelVector.H"
#include "processorCyclicPolyPatch.H"

namespace slidewave::foam {
namespace {

using namespace Foam;

Table::ConstColumn columns(vectorField const& field) {
  return {reinterpret_cast<double const*>(field.cdata()), 3, field.size()};
}

Vec3 vec3(vector const& v) {
  return {v.x(), v.y(), v.z()};
}

// One letter an axis: e empty (not solved), p periodic, b bounded. Where the mesh is cut across a
// periodic direction, its cyclic faces are processorCyclic ones of some of the ranks.
std::string boundaryLetters(fvMesh const& mesh) {
  labelVector periodic(0, 0, 0);
  for (polyPatch const& patch : mesh.boundaryMesh()) {
    if (!isA<cyclicPolyPatch>(patch) && !isA<processorCyclicPolyPatch>(patch)) continue;
    vector const separation = cmptMag(sum(patch.faceAreas()));
    for (direction d = 0; d < vector::nComponents; ++d) {
      if (separation[d] > 0.9 * mag(separation)) periodic[d] = 1;
    }
  }
  reduce(periodic, maxOp<labelVector>());
  std::string letters = "bbb";
  for (direction d = 0; d < vector::nComponents; ++d) {
    letters[d] = periodic[d] ? 'p' : mesh.geometricD()[d] < 0 ? 'e' : 'b';
  }
  return letters;
}

// The spline's own width counts towards the kernel's length: its variance is a quarter of the
// cell's squared size, that of smoothing over a length L is L^2/2.
ParticleKernel makeKernel(Scene const& scene, fvMesh const& mesh, MPI_Comm comm) {
  double const length_m = scene.number("coupling.smoothing_length", 0);
  MeshGraph graph = graphOfMesh(mesh, comm);
  std::string const deposit = scene.text("coupling.deposit", length_m > 0 ? "spline" : "centroid");
  if (deposit == "centroid") {
    return {Smoother(std::move(graph), length_m), CellStencil(mesh.nCells())};
  }
  if (deposit != "spline") {
    throw InputError((scene.directory() / "case.toml").string(), "coupling.deposit", deposit,
                     "give spline or centroid");
  }
  double const rest_m2 = sqr(length_m) - 0.5 * meanSquaredCellSize(mesh, comm);
  return {Smoother(std::move(graph), std::sqrt(std::max(rest_m2, 0.0))),
          CellStencil(shapesOfCells(mesh), periodOfMesh(mesh, comm), comm)};
}

// OpenFOAM says that a stream failed, not why.
std::string fullDisk(Scene const& scene) {
  std::error_code unknown;
  auto const room = std::filesystem::space(scene.directory() / "fluid", unknown);
  return !unknown && room.available < 65536 ? ": No space left on device" : "";
}

// Fields of the start are the case's input, even where the solver has bettered them since (p_rgh):
// as long as this lives they are not written over, so that the run can begin again and be the same.
class KeptInput {
 public:
  explicit KeptInput(fvMesh const& mesh) {
    for (regIOobject const* object : mesh.lookupClass<regIOobject>()) {
      if (object->readOpt() == IOobject::MUST_READ && object->writeOpt() == IOobject::AUTO_WRITE) {
        kept_.push_back(&mesh.lookupObjectRef<regIOobject>(object->name()));
        kept_.back()->writeOpt() = IOobject::NO_WRITE;
      }
    }
  }
  ~KeptInput() {
    for (regIOobject* object : kept_) object->writeOpt() = IOobject::AUTO_WRITE;
  }
  KeptInput(KeptInput const&) = delete;

 private:
  std::vector<regIOobject*> kept_;
};

}  // namespace

struct FoamEngine::Impl {
  Scene const& scene;
  FoamCase foam;
  std::unique_ptr<PorousFlow> flow;
  Locator locator;
  ParticleKernel kernel;
  SolidFraction solid;
  std::vector<std::unique_ptr<Observer>> observers;
  std::vector<Quantity> quantities;
  long particles = 0;  // of all ranks
  double output_interval_s, end_s;
  long outputs = -1;

  FieldSampler sampler;
  scalarField target;
  std::unique_ptr<DragDensity> drag;
  bool moves_along = false;               // virtual mass, two-way
  double const* added_mass_kg = nullptr;  // of the coming window, a particle each
  double const* volume_m3 = nullptr;      // likewise
  bool deposit_due = false;               // of that volume
  bool begun = false;                     // the initial state is there

  Impl(Scene const& the_scene, MPI_Comm the_comm, bool parallel)
      : scene(the_scene),
        foam(scene.directory() / "fluid", parallel, scene.number("case.end_time")),
        flow((refuseUnsupported(foam.mesh()), PorousFlow::New(foam.mesh(), foam.time()))),
        locator(foam.mesh()),
        kernel(makeKernel(scene, foam.mesh(), the_comm)),
        output_interval_s(scene.number("output.interval", 0)),
        end_s(scene.number("case.end_time")),
        sampler(*flow, kernel),
        target(foam.mesh().nCells()) {}

  void makeDrag() {
    fvMesh const& mesh = foam.mesh();
    auto const name = [&](char const* what) {
      return IOobject(what, mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE,
                      /*registerObject=*/false);
    };
    drag.reset(new DragDensity{
        {name("drag"), mesh, dimensionedScalar(dimMass / dimTime / dimVolume, Zero)},
        {name("dragVelocity"), mesh, dimensionedVector(dimForce / dimVolume, Zero)},
        {name("extraForce"), mesh, dimensionedVector(dimForce / dimVolume, Zero)},
        nullptr});
    if (moves_along) {
      drag->addedMass = std::make_unique<volScalarField::Internal>(
          name("addedMass"), mesh, dimensionedScalar(dimDensity, Zero));
    }
  }

  DragShares shares(Table::ConstColumn const& drag_kg_s, Table::ConstColumn const& velocity_m_s,
                    Table::ConstColumn const& force_N) const {
    return {sampler,   drag_kg_s.data(), velocity_m_s.data(), force_N.data(),
            volume_m3, added_mass_kg,    deposit_due,         moves_along};
  }

  void setDrag(DragShares const& shares, ParticleKernel::Fields const& density) {
    if (deposit_due) {
      solid.store(kernel, density, shares.volumeRow());
      setTarget();
    }
    if (!drag) makeDrag();
    for (label cell = 0; cell < foam.mesh().nCells(); ++cell) {
      double const weight = sampler.cellWeight(cell);
      drag->coefficient[cell] = weight * density(0, cell);
      for (direction d = 0; d < 3; ++d) {
        drag->velocitySource[cell][d] = weight * density(1 + d, cell);
        drag->force[cell][d] = weight * density(4 + d, cell);
      }
    }
    if (moves_along) {
      scalarField& added = *drag->addedMass;
      forAll(added, cell) added[cell] = sampler.cellWeight(cell) * density(shares.massRow(), cell);
    }
    flow->setDrag(drag.get());
  }

  void depositAlone() {
    solid.deposit(kernel, Table::ConstColumn(volume_m3, 1, kernel.particles()));
    setTarget();
  }

  void setTarget() {
    deposit_due = false;
    forAll(target, cell) target[cell] = solid.voidFraction(cell);
    flow->setTarget(target);
  }

  void write(double now_s) {
    long const due =
        output_interval_s > 0 ? std::lround(std::floor(now_s / output_interval_s + 1e-6)) : 0;
    if (due == outputs && now_s < end_s * (1 - 1e-9)) return;
    outputs = due;
    std::unique_ptr<KeptInput> const kept(now_s > 0 ? nullptr : new KeptInput(foam.mesh()));
    if (!foam.time().writeNow()) {
      throw std::runtime_error("OpenFOAM: cannot write the fields" + fullDisk(scene));
    }
  }

  void observe();
};

FoamEngine::FoamEngine(Scene const& scene, MPI_Comm comm) {
  int size = 0, rank = 0;
  MPI_Comm_size(comm, &size);
  MPI_Comm_rank(comm, &rank);
  impl_ = std::make_unique<Impl>(scene, comm, size > 1);
  Impl& self = *impl_;
  bool const coupled = scene.text("dem.engine", "none") != "none";
  bool const two_way = coupled && scene.text("coupling.reaction", "two_way") == "two_way";
  bool const concurrent = scene.text("coupling.scheme", "serial") == "concurrent";
  Means means;
  bool const whole = coupled && scene.text("models.formulation", "A") == "B";
  means.velocity = two_way && !concurrent;
  means.pressureGradient = coupled && scene.flag("models.pressure_gradient", !whole);
  means.carried = concurrent && means.pressureGradient;
  means.dragReaction = two_way && scene.text("coupling.regime", "auto") == "stiff";
  means.acceleration = coupled && scene.text("models.virtual_mass", "none") != "none";
  means.viscousStress = coupled && scene.flag("models.viscous_force", false);
  means.wholeStress = whole && two_way;
  self.moves_along = two_way && means.acceleration;
  self.flow->keepMeans(means);
  self.observers = makeObservers(scene, self.foam.mesh());
  if (rank == 0) std::ofstream(scene.directory() / "fluid" / "case.foam");  // what ParaView opens
}

FoamEngine::~FoamEngine() = default;

std::vector<std::pair<std::string, std::string>> FoamEngine::facts() const {
  std::vector<std::pair<std::string, std::string>> facts;
  auto const text = [](double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.17g", value);
    return std::string(buffer);
  };
  vector const g = readGravity(impl_->foam.mesh()).value();
  if (mag(g) > 0) facts.push_back({"gravity", text(g.x()) + ' ' + text(g.y()) + ' ' + text(g.z())});
  facts.push_back({"boundary", boundaryLetters(impl_->foam.mesh())});
  facts.push_back({"end_time", text(impl_->end_s)});
  return facts;
}

Box FoamEngine::bounds() const {
  return impl_->locator.bounds();
}

std::vector<Quantity> FoamEngine::quantities() const {
  return impl_->quantities;
}

std::vector<Feature> FoamEngine::features() const {
  bool const two_fluids = impl_->flow->budgets().size() == 2;
  int const steps = impl_->kernel.smoother().steps();
  bool const spline = impl_->kernel.stencil().isSpline();
  return {{"phase_equation", two_fluids, two_fluids ? "water and air (VOF)" : "one fluid"},
          {"spline_deposit", spline,
           spline ? "over the cells around, no jumps" : "each particle in its own cell"},
          {"kernel_smoothing", steps > 0, std::to_string(steps) + " face-flux steps"},
          {"turbulence", false, "laminar: no model has a form for flow in pores"}};
}

std::vector<Field> FoamEngine::samples() const {
  return {
      {"velocity", "m/s", 3},           {"mean_velocity", "m/s", 3},  {"density", "kg/m3", 1},
      {"viscosity", "Pa s", 1},         {"void_fraction", "-", 1},    {"saturation", "-", 1},
      {"pressure_gradient", "Pa/m", 3}, {"drag_reaction", "Pa/m", 3}, {"acceleration", "m/s2", 3},
      {"viscous_stress", "Pa/m", 3},    {"vorticity", "1/s", 3}};
}

Home FoamEngine::locate(Vec3 const& position_m, int hint_cell) {
  return impl_->locator.locate(position_m, hint_cell);
}

void FoamEngine::place(Table::ConstColumn position_m, std::vector<int> const& cell) {
  impl_->particles = impl_->kernel.place(position_m, cell);
  impl_->sampler.begin();
  impl_->flow->setDrag(nullptr);
}

// The volume goes to the cells together with the drag, where weights are worked out anyway: nothing
// looks at the target before the flow advances, except in window 0, where it is the initial state.
void FoamEngine::deposit(Table::ConstColumn volume_m3) {
  impl_->volume_m3 = volume_m3.data();
  impl_->deposit_due = true;
  if (!impl_->begun) impl_->depositAlone();
}

void FoamEngine::add_mass(Table::ConstColumn const& added_mass_kg) {
  impl_->added_mass_kg = added_mass_kg.data();
}

void FoamEngine::exchange(Table::ConstColumn drag_kg_s, Table::ConstColumn velocity_m_s,
                          Table::ConstColumn force_N) {
  Impl& self = *impl_;
  if (self.particles == 0) return;
  self.sampler.weighParticles();
  DragShares const shares = self.shares(drag_kg_s, velocity_m_s, force_N);
  self.setDrag(shares, self.kernel.spread(shares.rows(), shares));
}

void FoamEngine::sample_and_exchange(std::vector<Sample> const& samples, RowWork const& evaluate,
                                     Table::ConstColumn const& drag_kg_s,
                                     Table::ConstColumn const& velocity_m_s,
                                     Table::ConstColumn const& force_N) {
  Impl& self = *impl_;
  if (self.particles == 0) return;
  DragShares const shares = self.shares(drag_kg_s, velocity_m_s, force_N);
  self.sampler.prepare(samples);  // the weights are always to be gathered
  auto const take = [&](int particle, double const* values, int stride) {
    self.sampler.take(particle, values, stride);
  };
  self.setDrag(shares, self.kernel.exchange(shares.rows(), take, evaluate, shares));
}

void FoamEngine::advance(Window const& window) try {
  Impl& self = *impl_;
  if (self.deposit_due) self.depositAlone();  // no drag took it along
  if (self.particles > 0) self.sampler.weigh();
  if (window.index == 0) {
    self.flow->initialise();
  } else {
    self.flow->advance(window.t1_s);
  }
  self.begun = true;
  self.observe();
  self.write(window.t1_s);
} catch (Foam::error const& problem) {  // callers know no OpenFOAM
  Info << problem << endl;
  throw std::runtime_error("OpenFOAM: " + problem.message() + fullDisk(impl_->scene));
}

void FoamEngine::Impl::observe() {
  double const moved_m3 = solid.moved_m3();
  scalarField const& eps = flow->eps();
  scalarField const water(flow->saturation()().primitiveField() * eps);
  quantities.clear();
  for (VolumeBudget const& budget : flow->budgets()) {
    quantities.push_back({budget.name + "_volume_m3", budget.now_m3});
    quantities.push_back({budget.name + "_volume_defect", budget.defect()});
    quantities.push_back({budget.name + "_outflow_m3", budget.out_m3});
  }
  quantities.push_back({"max_courant", flow->maxCourant()});
  quantities.push_back({"min_void_fraction", gMin(eps)});
  quantities.push_back({"solid_spread_m3", moved_m3});
  quantities.push_back({"fluid_steps", static_cast<double>(flow->steps())});
  WaterView const view{foam.mesh(), kernel.smoother().graph(), eps, water,
                       flow->U().primitiveField()};
  for (auto const& observer : observers) {
    for (Quantity const& quantity : observer->observe(view)) quantities.push_back(quantity);
  }
}

void FoamEngine::sample(std::string const& field, Table::Column out) {
  sample_all({{field, out}});
}

void FoamEngine::sample_all(std::vector<Sample> const& samples) {
  if (impl_->particles > 0) impl_->sampler.sample(samples);
}

void FoamEngine::pass(State& state) try {
  Impl& self = *impl_;
  self.foam.pass(state);  // first: fields keep old times by the number of the step
  state.pass("foam.outputs", self.outputs);
  FieldState fields(state, self.foam.mesh());
  self.flow->pass(fields);
  self.begun = true;
} catch (Foam::error const& problem) {
  Info << problem << endl;
  throw std::runtime_error("OpenFOAM: " + problem.message());
}

Vec3 FoamEngine::given_impulse() const {
  return vec3(impl_->flow->given());
}

double FoamEngine::solid_volume_m3() const {
  return impl_->solid.volume_m3(impl_->kernel);
}

Vec3 FoamEngine::solid_pressure_force() const {
  vectorField const& gradient = impl_->flow->meanPressureGradient();
  if (gradient.empty()) return Vec3::Zero();
  return impl_->solid.integrate(impl_->kernel, columns(gradient));
}

Vec3 FoamEngine::solid_reaction_force() const {
  if (impl_->particles == 0) return Vec3::Zero();
  return impl_->solid.integrate(impl_->kernel, columns(impl_->flow->meanDragReaction()));
}

}  // namespace slidewave::foam
