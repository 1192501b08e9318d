#include <algorithm>
#include <cmath>

#include "OneFluid.H"
#include "PorousFlow.H"
#include "TwoFluids.H"
#include "World.H"
#include "adjustPhi.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "fixedValueFvPatchFields.H"
#include "fvc.H"
#include "fvm.H"
#include "zeroGradientFvPatchFields.H"

namespace slidewave::foam {

using namespace Foam;

void VolumeBudget::add(double volume_m3, double stepOut_m3) {
  now_m3 = volume_m3;
  if (initial_m3 < 0) {
    initial_m3 = volume_m3;
  } else {
    out_m3 += stepOut_m3;
  }
}

double VolumeBudget::defect() const {
  return std::abs(now_m3 - initial_m3 + out_m3) / std::max({initial_m3, now_m3, VSMALL});
}

void VolumeBudget::pass(State& state) {
  state.pass("volume." + name + ".initial_m3", initial_m3);
  state.pass("volume." + name + ".now_m3", now_m3);
  state.pass("volume." + name + ".out_m3", out_m3);
}

scalar boundaryOutflow(surfaceScalarField const& flux) {
  scalar out = 0;
  for (fvsPatchScalarField const& patch : flux.boundaryField()) {
    if (!patch.coupled()) out += sum(patch);
  }
  reduce(out, sumOp<scalar>());
  return out;
}

std::unique_ptr<PorousFlow> PorousFlow::New(fvMesh& mesh, Time& time) {
  IOdictionary const transport(IOobject("transportProperties", time.constant(), mesh,
                                        IOobject::MUST_READ, IOobject::NO_WRITE,
                                        /*registerObject=*/false));
  if (transport.found("phases")) return std::make_unique<TwoFluids>(mesh, time);
  return std::make_unique<OneFluid>(mesh, time);
}

namespace {

IOobject stored(word const& name, fvMesh const& mesh, IOobject::readOption read,
                IOobject::writeOption write) {
  return IOobject(name, mesh.time().timeName(), mesh, read, write);
}

}  // namespace

PorousFlow::PorousFlow(fvMesh& mesh, Time& time, word const& pressure)
    : mesh_(mesh),
      time_(time),
      pimple_(mesh),
      p_(stored(pressure, mesh, IOobject::MUST_READ, IOobject::AUTO_WRITE), mesh),
      U_(stored("U", mesh, IOobject::MUST_READ, IOobject::AUTO_WRITE), mesh),
      g_(IOobject("g", time.constant(), mesh, IOobject::READ_IF_PRESENT),
         dimensionedVector("g", dimAcceleration, Zero)),
      eps_(stored("eps", mesh, IOobject::NO_READ, IOobject::AUTO_WRITE), mesh,
           dimensionedScalar("eps", dimless, 1), zeroGradientFvPatchScalarField::typeName),
      epsf_("epsf", fvc::interpolate(eps_)),
      phi_(stored("phi", mesh, IOobject::NO_READ, IOobject::NO_WRITE), fvc::flux(U_)),
      F_("F", epsf_ * phi_),
      rate_(stored("rate", mesh, IOobject::NO_READ, IOobject::NO_WRITE), mesh,
            dimensionedScalar("rate", dimless / dimTime, 0)),
      stepSize_(time) {
  eps_.oldTime();
  phi_.oldTime();
  F_.oldTime();
  mesh_.setFluxRequired(p_.name());
}

PorousFlow::~PorousFlow() = default;

void PorousFlow::keepMeans(Means const& wanted) {
  means_ = wanted;
  label const cells = mesh_.nCells();
  if (means_.velocity) meanU_.setSize(cells, Zero);
  if (means_.pressureGradient) meanGradP_.setSize(cells, Zero);
  if (means_.dragReaction) meanReaction_.setSize(cells, Zero);
  if (means_.acceleration) meanAcceleration_.setSize(cells, Zero);
  if (means_.viscousStress) meanStress_.setSize(cells, Zero);
  dimensionedScalar const one("one", dimless, 1);
  if (means_.viscousStress || means_.wholeStress) {
    one_ = std::make_unique<volScalarField>(
        stored("one", mesh_, IOobject::NO_READ, IOobject::NO_WRITE), mesh_, one);
  }
  if (means_.wholeStress) {
    oneOnFaces_ = std::make_unique<surfaceScalarField>(
        stored("onef", mesh_, IOobject::NO_READ, IOobject::NO_WRITE), mesh_, one);
  }
}

void PorousFlow::setTarget(scalarField const& eps) {
  if (!target_) target_ = std::make_unique<scalarField>(eps.size());
  *target_ = eps;
  if (initialised_) return;
  rampTo(1);
  eps_.oldTime() == eps_;
  setFlux(epsf_ * phi_);
}

void PorousFlow::initialise() {
  initialised_ = true;
  TrapFloatingPoint const trap;
  solveHydrostatic();
  if (means_.velocity) meanU_ = U_.primitiveField();
  if (means_.pressureGradient) meanGradP_ = pressureGradient()();
  accountVolumes();
}

void PorousFlow::advance(double end_s) {
  double const begin_s = time_.value();
  TrapFloatingPoint const trap;
  startWindow(end_s - begin_s);
  while (time_.value() < end_s - 1e-9 * (end_s - begin_s)) {
    double const last_s = time_.deltaTValue();
    double const courant =
        courantNumber(F_, eps_, target_ ? *target_ : eps_.primitiveField(), last_s);
    maxCourant_ = std::max(maxCourant_, courant);
    time_.setDeltaT(stepSize_.next(time_.value(), end_s, courant, interfaceCourant(), last_s),
                    false);
    Info << "Courant " << courant << " dt " << time_.deltaTValue() << nl;
    ++time_;
    Info << "Time = " << time_.timeName() << nl << endl;
    rampTo((time_.value() - begin_s) / (end_s - begin_s));
    solveStep();
    account();
    time_.run();  // the case's function objects
    ++steps_;
  }
  time_.setTime(end_s, time_.timeIndex());
  double const window_s = end_s - begin_s;
  for (vectorField* mean :
       {&meanU_, &meanGradP_, &meanReaction_, &meanAcceleration_, &meanStress_}) {
    *mean /= window_s;
  }
  start_.reset();
}

// The ramp's slope, and a flux that satisfies continuity with it from the first step on: otherwise
// the phase equation would see the last window's rate, and saturation would leave [0, 1].
void PorousFlow::startWindow(double length_s) {
  for (vectorField* mean :
       {&meanU_, &meanGradP_, &meanReaction_, &meanAcceleration_, &meanStress_}) {
    *mean = Zero;
  }
  given_ = Zero;
  if (!target_) return;
  start_ = std::make_unique<scalarField>(eps_.primitiveField());
  scalarField rate((*target_ - *start_) / length_s);
  if (p_.needReference()) {
    scalarField const& V = mesh_.V();
    scalar const excess = gSum((rate * V)()) / gSum(V);
    if (mag(excess) * length_s > 1e-9) {
      FatalErrorInFunction << "solid volume enters or leaves a closed domain: mean d(eps)/dt = "
                           << excess << " 1/s; particles must stay inside, or a patch must fix the "
                           << "pressure" << exit(FatalError);
    }
    rate -= excess;
  }
  scalar const change = gMax(mag(rate - rate_.primitiveField())());
  rate_.primitiveFieldRef() = rate;
  if (change * length_s > 1e-13) projectFlux();
}

// As OpenFOAM's CorrectPhi, but that one holds cell 0 of every rank where nothing fixes the
// pressure: in a decomposed closed domain the flux then misses continuity there.
void PorousFlow::projectFlux() {
  wordList kinds(p_.boundaryField().size(), zeroGradientFvPatchScalarField::typeName);
  forAll(kinds, patch) {
    if (p_.boundaryField()[patch].fixesValue()) {
      kinds[patch] = fixedValueFvPatchScalarField::typeName;
    }
  }
  volScalarField pcorr(stored("pcorr", mesh_, IOobject::NO_READ, IOobject::NO_WRITE), mesh_,
                       dimensionedScalar(p_.dimensions(), Zero), kinds);
  surfaceScalarField const mobility(epsf_ * faceMobility());
  surfaceScalarField F("F", F_ * 1.0);
  if (pcorr.needReference()) adjustPhi(F, U_, pcorr);
  mesh_.setFluxRequired(pcorr.name());
  while (pimple_.correctNonOrthogonal()) {
    fvScalarMatrix equation(fvm::laplacian(mobility, pcorr) == fvc::div(F) + rate_);
    equation.setReference(Pstream::master() ? 0 : -1, 0);
    equation.solve(mesh_.solver(pcorr.select(pimple_.finalNonOrthogonalIter())));
    if (pimple_.finalNonOrthogonalIter()) setFlux(F - equation.flux());
  }
}

void PorousFlow::rampTo(double fraction) {
  if (!target_) return;
  if (fraction > 1 - 1e-9 || !start_) {
    eps_.primitiveFieldRef() = *target_;
  } else {
    eps_.primitiveFieldRef() = *start_ + fraction * (*target_ - *start_);
  }
  eps_.correctBoundaryConditions();
  epsf_ = fvc::interpolate(eps_);
}

void PorousFlow::setFlux(tmp<surfaceScalarField> const& F) {
  F_ = F;
  phi_ = F_ / epsf_;
}

// The old flux is compared with that of the product eps U: U alone, taken to a face where eps
// jumps, differs from F/eps_f even where both say the same flux, and steady flow would keep the
// difference.
tmp<surfaceScalarField> PorousFlow::oldFlux() const {
  return fvc::ddtCorr(eps_, U_, F_);
}

void PorousFlow::addDrag(fvVectorMatrix& UEqn, dimensionedScalar const& scale) const {
  if (!drag_) return;
  UEqn += fvm::Sp(scale * drag_->coefficient, U_);
  if (!dragOnFaces()) UEqn -= scale * (drag_->velocitySource + drag_->force);
}

void PorousFlow::addInertia(fvVectorMatrix& UEqn, dimensionedScalar const& scale,
                            word const& scheme) {
  if (!means_.acceleration) return;
  DUDt_ = std::make_unique<fvVectorMatrix>(fvm::ddt(U_) + fvm::div(phi_, U_, scheme) -
                                           fvm::Sp(fvc::div(phi_)(), U_));
  if (drag_ && drag_->addedMass) UEqn += (scale * *drag_->addedMass) * *DUDt_;
}

tmp<fvVectorMatrix> PorousFlow::carried(tmp<fvVectorMatrix> stress,
                                        dimensionedScalar const& scale) {
  if (!means_.viscousStress) return stress;
  stress_ = std::make_unique<fvVectorMatrix>(stress());
  stressScale_ = scale.value();
  return eps_() * stress;
}

tmp<volScalarField> PorousFlow::withAddedMass(tmp<volScalarField> fluid,
                                              dimensionedScalar const& scale) const {
  if (!drag_ || !drag_->addedMass) return fluid;
  tmp<volScalarField> both(new volScalarField(fluid));
  both.ref().primitiveFieldRef() += scale.value() * drag_->addedMass->field();
  both.ref().correctBoundaryConditions();
  return both;
}

tmp<vectorField> PorousFlow::dragPush() const {
  return (drag_->velocitySource.field() + drag_->force.field()) / eps_.primitiveField();
}

tmp<surfaceScalarField> PorousFlow::dragForce(dimensionedScalar const& scale) const {
  volVectorField push(stored("dragPush", mesh_, IOobject::NO_READ, IOobject::NO_WRITE), mesh_,
                      dimensionedVector(scale.dimensions() * dimForce / dimVolume, Zero),
                      zeroGradientFvPatchVectorField::typeName);
  push.primitiveFieldRef() = scale.value() * dragPush();
  push.correctBoundaryConditions();
  tmp<surfaceScalarField> force = (fvc::interpolate(push) & mesh_.Sf()) / mesh_.magSf();
  forAll(p_.boundaryField(), patch) {
    if (!p_.boundaryField()[patch].coupled() && !p_.boundaryField()[patch].fixesValue()) {
      force.ref().boundaryFieldRef()[patch] = 0;
    }
  }
  return force;
}

void PorousFlow::pass(FieldState& fields) {
  fields.pass(eps_);
  epsf_ = fvc::interpolate(eps_);
  U_.oldTime();  // kept from now on: the next step must not find a field that it has changed
  fields.pass(U_);
  fields.pass(p_);
  fields.pass(phi_);
  fields.pass(F_);
  fields.pass(rate_);
  if (means_.carried) fields.passCells("meanGradP", meanGradP_);
  State& state = fields.state();
  stepSize_.pass(state);
  state.pass("flow.steps", steps_);
  state.pass("flow.max_courant", maxCourant_);
  initialised_ = true;
}

void PorousFlow::account() {
  double const dt_s = time_.deltaTValue();
  accountVolumes();
  if (means_.velocity) meanU_ += dt_s * U_.primitiveField();
  if (means_.pressureGradient) meanGradP_ += dt_s * pressureGradient();
  tmp<volVectorField> DUDt;
  if (DUDt_) {
    DUDt = *DUDt_ & U_;
    meanAcceleration_ += dt_s * DUDt().primitiveField();
  }
  if (stress_) meanStress_ -= dt_s / stressScale_ * (*stress_ & U_)().primitiveField();
  if (drag_) {
    vectorField taken(drag_->coefficient.field() * U_.primitiveField() -
                      drag_->velocitySource.field() - drag_->force.field());
    if (drag_->addedMass) taken += drag_->addedMass->field() * DUDt().primitiveField();
    given_ += dt_s * sum((taken * mesh_.V().field())());
    if (means_.dragReaction) meanReaction_ += dt_s * taken / eps_.primitiveField();
  }
}

}  // namespace slidewave::foam
