#include "OneFluid.H"
#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvc.H"
#include "fvm.H"

namespace slidewave::foam {

using namespace Foam;

namespace {

IOdictionary transportProperties(fvMesh const& mesh) {
  return IOdictionary(IOobject("transportProperties", mesh.time().constant(), mesh,
                               IOobject::MUST_READ, IOobject::NO_WRITE, /*registerObject=*/false));
}

}  // namespace

OneFluid::OneFluid(fvMesh& mesh, Time& time)
    : PorousFlow(mesh, time, "p"),
      nu_("nu", dimViscosity, transportProperties(mesh)),
      rho_("rho", dimDensity, transportProperties(mesh).lookupOrDefault<scalar>("rho", 1000)),
      fluid_constants_{rho_.value(), (rho_ * nu_).value()},
      balance_(IOobject("balance", time.timeName(), mesh), mesh,
               dimensionedVector("balance", dimAcceleration, Zero)) {
  if (transportProperties(mesh).lookupOrDefault<word>("transportModel", "Newtonian") !=
      "Newtonian") {
    FatalErrorInFunction << "transportProperties: only transportModel Newtonian"
                         << exit(FatalError);
  }
  setRefCell(p_, pimple_.dict(), pRefCell_, pRefValue_);
}

void OneFluid::solveStep() {
  while (pimple_.loop()) {
    surfaceScalarField const inertia(oldFlux());
    tmp<fvVectorMatrix> tUEqn = momentum();
    while (pimple_.correct()) correctPressure(tUEqn.ref(), inertia);
  }
}

tmp<fvVectorMatrix> OneFluid::momentum() {
  volScalarField const nu("nuEff", viscousShare() * nu_);
  tmp<fvVectorMatrix> tUEqn(
      (fvm::ddt(eps_, U_) + fvm::div(F_, U_, "div(phi,U)")) +
      carried(-fvc::div(nu * dev2(T(fvc::grad(U_)))) - fvm::laplacian(nu, U_), 1 / rho_));
  fvVectorMatrix& UEqn = tUEqn.ref();
  addDrag(UEqn, 1 / rho_);
  addInertia(UEqn, 1 / rho_, "div(phi,U)");
  UEqn.relax();
  if (pimple_.momentumPredictor()) {
    if (dragOnFaces()) {
      solve(UEqn ==
            eps_ * fvc::reconstruct((dragForce(1 / rho_) - fvc::snGrad(p_)) * mesh_.magSf()));
    } else {
      solve(UEqn == -share() * fvc::grad(p_));
    }
  }
  return tUEqn;
}

void OneFluid::correctPressure(fvVectorMatrix& UEqn, surfaceScalarField const& inertia) {
  volScalarField const rAU(1 / UEqn.A());
  surfaceScalarField const rAUf("rAUf", epsf_ * shareOnFaces() * fvc::interpolate(rAU));
  volVectorField const HbyA(constrainHbyA(rAU * UEqn.H(), U_, p_));
  surfaceScalarField F(
      "phiHbyA",
      fvc::flux(eps_ * HbyA) + fvc::interpolate(withAddedMass(eps_, 1 / rho_) * rAU) * inertia);
  if (p_.needReference()) adjustPhi(F, U_, p_);
  tmp<surfaceScalarField> push;
  if (dragOnFaces()) {
    push = dragForce(1 / rho_) * rAUf * mesh_.magSf();
    F += push();
  }
  constrainPressure(p_, eps_, U_, F, rAUf);

  while (pimple_.correctNonOrthogonal()) {
    fvScalarMatrix pEqn(fvm::laplacian(rAUf, p_) == fvc::div(F) + rate_);
    pEqn.setReference(pRefCell_, pRefValue_);
    pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));
    if (pimple_.finalNonOrthogonalIter()) {
      setFlux(F - pEqn.flux());
      if (dragOnFaces()) balance_ = fvc::reconstruct((push() - pEqn.flux()) / rAUf);
    }
  }
  p_.relax();
  if (dragOnFaces()) {
    U_ = HbyA + rAU * eps_ * balance_;
  } else {
    U_ = HbyA - rAU * share() * fvc::grad(p_);
  }
  U_.correctBoundaryConditions();
}

tmp<vectorField> OneFluid::pressureGradient() const {
  if (dragOnFaces()) {
    return dragPush() + rho_.value() * (g_.value() - balance_.primitiveField());
  }
  return rho_.value() * (fvc::grad(p_)().primitiveField() + g_.value());
}

tmp<surfaceScalarField> OneFluid::faceMobility() const {
  return surfaceScalarField::New("mobility", mesh_, time_.deltaT());
}

void OneFluid::accountVolumes() {
  fluid_.add(gSum((eps_.primitiveField() * mesh_.V().field())()),
             time_.deltaTValue() * boundaryOutflow(F_));
}

void OneFluid::pass(FieldState& fields) {
  PorousFlow::pass(fields);
  fluid_.pass(fields.state());
}

tmp<volScalarField> OneFluid::uniform(dimensionedScalar const& value) const {
  return volScalarField::New(value.name(), mesh_, value);
}

tmp<volScalarField> OneFluid::density() const {
  return uniform(rho_);
}
tmp<volScalarField> OneFluid::dynamicViscosity() const {
  return uniform(rho_ * nu_);
}
tmp<volScalarField> OneFluid::saturation() const {
  return uniform(dimensionedScalar("saturation", dimless, 1));
}

}  // namespace slidewave::foam
