#include "TwoFluids.H"
#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvc.H"
#include "fvm.H"

namespace slidewave::foam {

using namespace Foam;

namespace {

// Height above the reference level, along gravity: g.x = gh + g.h_ref.
dimensionedScalar referenceHead(fvMesh const& mesh, dimensionedVector const& g) {
  uniformDimensionedScalarField const hRef(
      IOobject("hRef", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT),
      dimensionedScalar("hRef", dimLength, 0));
  if (mag(g.value()) < SMALL) return {"ghRef", g.dimensions() * dimLength, 0};
  return g & (cmptMag(g.value()) / mag(g.value())) * hRef;
}

}  // namespace

TwoFluids::TwoFluids(fvMesh& mesh, Time& time)
    : PorousFlow(mesh, time, "p_rgh"),
      mixture_(U_, phi_),
      rho_("rho", mixture_.alpha1() * mixture_.rho1() + mixture_.alpha2() * mixture_.rho2()),
      alphaF_("alphaF", F_ * fvc::interpolate(mixture_.alpha1())),
      rhoF_("rhoPhi", fvc::interpolate(rho_) * F_),
      gh_("gh", (g_ & mesh.C()) - referenceHead(mesh, g_)),
      ghf_("ghf", (g_ & mesh.Cf()) - referenceHead(mesh, g_)),
      p_full_(IOobject("p", time.timeName(), mesh, IOobject::NO_READ, IOobject::AUTO_WRITE),
              p_ + rho_ * gh_),
      balance_(IOobject("balance", time.timeName(), mesh), mesh,
               dimensionedVector("balance", dimForce / dimVolume, Zero)) {
  rho_.oldTime();
  mesh_.setFluxRequired(mixture_.alpha1().name());
  setRefCell(p_full_, p_, pimple_.dict(), pRefCell_, pRefValue_);
  setPressure();
}

void TwoFluids::solveStep() {
  while (pimple_.loop()) {
    solvePhase();
    mixture_.correct();
    surfaceScalarField const force(bodyForce());
    surfaceScalarField const inertia(oldFlux());
    tmp<fvVectorMatrix> tUEqn = momentum(force);
    while (pimple_.correct()) correctPressure(tUEqn.ref(), force, inertia);
    setPressure();
  }
}

tmp<fvVectorMatrix> TwoFluids::momentum(surfaceScalarField const& force) {
  dimensionedScalar const one("one", dimless, 1);
  volScalarField const mu("(rho*nuEff)", viscousShare() * rho_ * mixture_.nu());
  tmp<fvVectorMatrix> tUEqn(
      (fvm::ddt(eps_, rho_, U_) + fvm::div(rhoF_, U_)) +
      carried(-fvc::div(mu * dev2(T(fvc::grad(U_)))) - fvm::laplacian(mu, U_), one));
  fvVectorMatrix& UEqn = tUEqn.ref();
  addDrag(UEqn, one);
  addInertia(UEqn, one, "div(rhoPhi,U)");
  UEqn.relax();
  if (pimple_.momentumPredictor()) {
    solve(UEqn == share() * fvc::reconstruct((force - fvc::snGrad(p_)) * mesh_.magSf()));
  }
  return tUEqn;
}

// Face-normal forces [N/m3] other than the pressure that is solved for.
tmp<surfaceScalarField> TwoFluids::bodyForce() const {
  tmp<surfaceScalarField> force = mixture_.surfaceTensionForce() - ghf_ * fvc::snGrad(rho_);
  if (dragOnFaces()) force.ref() += dragForce(dimensionedScalar("one", dimless, 1));
  return force;
}

// `force` and `inertia` (the old flux's part of the time derivative) stay the same in all
// corrections.
void TwoFluids::correctPressure(fvVectorMatrix& UEqn, surfaceScalarField const& force,
                                surfaceScalarField const& inertia) {
  volScalarField const rAU(1 / UEqn.A());
  surfaceScalarField const rAUf("rAUf", epsf_ * shareOnFaces() * fvc::interpolate(rAU));
  volVectorField const HbyA(constrainHbyA(rAU * UEqn.H(), U_, p_));
  // eps HbyA goes to the faces as one product: its flux is smooth where eps jumps.
  dimensionedScalar const one("one", dimless, 1);
  surfaceScalarField F(
      "phiHbyA",
      fvc::flux(eps_ * HbyA) + fvc::interpolate(withAddedMass(eps_ * rho_, one) * rAU) * inertia);
  if (p_.needReference()) adjustPhi(F, U_, p_);
  surfaceScalarField const forceFlux(force * rAUf * mesh_.magSf());
  F += forceFlux;
  constrainPressure(p_, eps_, U_, F, rAUf);

  while (pimple_.correctNonOrthogonal()) {
    fvScalarMatrix pEqn(fvm::laplacian(rAUf, p_) == fvc::div(F) + rate_);
    pEqn.setReference(pRefCell_, getRefCellValue(p_, pRefCell_));
    pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));
    if (pimple_.finalNonOrthogonalIter()) {
      tmp<surfaceScalarField> const flux = pEqn.flux();
      setFlux(F - flux());
      p_.relax();
      balance_ = fvc::reconstruct((forceFlux - flux()) / rAUf);
      U_ = HbyA + rAU * share() * balance_;
      U_.correctBoundaryConditions();
    }
  }
}

// Pressure in equilibrium with gravity, in pores and in open water alike.
void TwoFluids::solveHydrostatic() {
  surfaceScalarField const rAUf("rAUf", epsf_ * faceMobility());
  surfaceScalarField const forceFlux(bodyForce() * rAUf * mesh_.magSf());
  constrainPressure(p_, eps_, (0 * U_)(), forceFlux, rAUf);
  tmp<surfaceScalarField> flux;
  for (int pass = 0; pass <= 5 * pimple_.nNonOrthCorr(); ++pass) {
    fvScalarMatrix pEqn(fvm::laplacian(rAUf, p_) == fvc::div(forceFlux));
    pEqn.setReference(pRefCell_, getRefCellValue(p_, pRefCell_));
    pEqn.solve(mesh_.solver(p_.select(true)));
    flux = pEqn.flux();
  }
  balance_ = fvc::reconstruct((forceFlux - flux) / rAUf);
  setPressure();
}

void TwoFluids::setPressure() {
  p_full_ == p_ + rho_* gh_;
  if (p_.needReference()) {
    p_full_ +=
        dimensionedScalar("p", p_.dimensions(), pRefValue_ - getRefCellValue(p_full_, pRefCell_));
    p_ = p_full_ - rho_ * gh_;
  }
}

tmp<vectorField> TwoFluids::pressureGradient() const {
  tmp<vectorField> gradient = rho_.primitiveField() * g_.value() - balance_.primitiveField();
  if (dragOnFaces()) gradient.ref() += dragPush();
  return gradient;
}

tmp<surfaceScalarField> TwoFluids::faceMobility() const {
  return time_.deltaT() / fvc::interpolate(rho_);
}

// The curvature of the interface too: where a contact angle is set it cannot be made from alpha
// again.
void TwoFluids::pass(FieldState& fields) {
  PorousFlow::pass(fields);
  mixture_.alpha1().oldTime();
  fields.pass(mixture_.alpha1());
  fields.pass(mixture_.alpha2());
  fields.pass(rho_);
  fields.pass(p_full_);
  fields.pass(alphaF_);
  fields.pass(rhoF_);
  fields.pass(balance_);
  if (!fields.state().saving()) mixture_.correct();
  fields.pass(mesh_.lookupObjectRef<surfaceScalarField>("nHatf"));
  fields.pass(mesh_.lookupObjectRef<volScalarField>("interfaceProperties:K"));
  water_.pass(fields.state());
  air_.pass(fields.state());
}

scalar TwoFluids::interfaceCourant() const {
  scalarField const near(mixture_.nearInterface()().primitiveField());
  return courantNumber(F_, eps_, eps_, time_.deltaTValue(), &near);
}

void TwoFluids::accountVolumes() {
  scalarField const pores(eps_.primitiveField() * mesh_.V().field());
  scalarField const& a = mixture_.alpha1();
  water_.add(gSum((pores * a)()), waterOutStep_);
  air_.add(gSum((pores * (1 - a))()), airOutStep_);
}

}  // namespace slidewave::foam
