// The phase equation of TwoFluids: d(eps a)/dt + div(a F) + div(compression) = 0, bounded by MULES
// with eps as its density; F satisfies d(eps)/dt + div F = 0, so that a = 1 stays 1.
#include "CMULES.H"
#include "TwoFluids.H"
#include "fvc.H"
#include "fvm.H"
#include "gaussConvectionScheme.H"
#include "subCycle.H"
#include "upwind.H"

namespace slidewave::foam {

using namespace Foam;

namespace {

// The void fraction at both ends of a (sub-)step, in the shape that MULES takes a density.
struct PorosityStep {
  scalarField const& now;
  scalarField const& before;
  struct Before {
    scalarField const& value;
    scalarField const& field() const { return value; }
  };
  scalarField const& field() const { return now; }
  Before oldTime() const { return {before}; }
};

struct PhaseControls {
  label corrections;
  bool implicitPredictor;
  scalar isotropic;
  explicit PhaseControls(dictionary const& dict)
      : corrections(dict.get<label>("nAlphaCorr")),
        implicitPredictor(dict.lookupOrDefault("MULESCorr", false)),
        isotropic(dict.lookupOrDefault<scalar>("icAlpha", 0)) {
    if (dict.lookupOrDefault("alphaApplyPrevCorr", false) ||
        dict.lookupOrDefault<scalar>("scAlpha", 0) > 0) {
      FatalErrorInFunction << "fvSolution: alphaApplyPrevCorr and scAlpha are not supported"
                           << exit(FatalError);
    }
  }
};

}  // namespace

// Sub-cycles see the void fraction of their own times: linear between the ends of the step.
void TwoFluids::solvePhase() {
  label const cycles = mesh_.solverDict(mixture_.alpha1().name()).get<label>("nAlphaSubCycles");
  scalarField const& eps = eps_;
  scalarField const& eps0 = eps_.oldTime();
  volScalarField& a = mixture_.alpha1();
  waterOutStep_ = 0;
  if (cycles == 1) {
    solvePhaseStep(eps, eps0);
  } else {
    surfaceScalarField sum("rhoPhiSum", 0 * rhoF_);
    int i = 0;
    for (subCycle<volScalarField> cycle(a, cycles); !(++cycle).end(); ++i) {
      scalar const begin = scalar(i) / cycles, end = scalar(i + 1) / cycles;
      solvePhaseStep(eps0 + end * (eps - eps0), eps0 + begin * (eps - eps0));
      sum += rhoF_ / cycles;
    }
    rhoF_ = sum;
  }
  airOutStep_ = time_.deltaTValue() * boundaryOutflow(F_) - waterOutStep_;
  rho_ == a* mixture_.rho1() + mixture_.alpha2() * mixture_.rho2();
}

void TwoFluids::solvePhaseStep(scalarField const& eps, scalarField const& eps0) {
  volScalarField& a = mixture_.alpha1();
  volScalarField& air = mixture_.alpha2();
  PhaseControls const controls(mesh_.solverDict(a.name()));
  PorosityStep const pores{eps, eps0};
  surfaceScalarField const compression(compressionFlux(controls.isotropic));

  if (controls.implicitPredictor) {
    fvScalarMatrix aEqn(
        fv::gaussConvectionScheme<scalar>(mesh_, F_, upwind<scalar>(mesh_, F_)).fvmDiv(F_, a));
    scalarField const perStep(mesh_.V().field() / time_.deltaTValue());
    aEqn.diag() += eps * perStep;
    aEqn.source() += eps0 * perStep * a.oldTime().primitiveField();
    aEqn.solve();
    alphaF_ = aEqn.flux();
    air = 1 - a;
    mixture_.correct();
  }

  for (int correction = 0; correction < controls.corrections; ++correction) {
    surfaceScalarField const phir(compression * mixture_.nHatf());
    word const compressed("div(phirb,alpha)");
    surfaceScalarField unbounded(fvc::flux(F_, a, "div(phi,alpha)") +
                                 fvc::flux(-fvc::flux(-phir, air, compressed), a, compressed));

    if (controls.implicitPredictor) {
      surfaceScalarField change(unbounded - alphaF_);
      volScalarField const before("before", a);
      MULES::correct(pores, a, unbounded, change, zeroField(), zeroField(), oneField(),
                     zeroField());
      if (correction > 0) {  // under-relaxed, but for the first
        a = 0.5 * a + 0.5 * before;
        change *= 0.5;
      }
      alphaF_ += change;
    } else {
      alphaF_ = unbounded;
      MULES::explicitSolve(pores, a, F_, alphaF_, zeroField(), zeroField(), oneField(),
                           zeroField());
    }
    air = 1 - a;
    mixture_.correct();
  }
  rhoF_ = alphaF_ * (mixture_.rho1() - mixture_.rho2()) + F_ * mixture_.rho2();
  waterOutStep_ += time_.deltaTValue() * boundaryOutflow(alphaF_);
}

// Speed of interface compression times cAlpha, zero on boundaries: nothing is compressed there.
tmp<surfaceScalarField> TwoFluids::compressionFlux(scalar isotropic) const {
  tmp<surfaceScalarField> tspeed(mixture_.cAlpha() * mag(F_ / mesh_.magSf()));
  surfaceScalarField& speed = tspeed.ref();
  if (isotropic > 0) {
    speed *= 1 - isotropic;
    speed += mixture_.cAlpha() * isotropic * epsf_ * fvc::interpolate(mag(U_));
  }
  for (fvsPatchScalarField& patch : speed.boundaryFieldRef()) {
    if (!patch.coupled()) patch == 0;
  }
  return tspeed;
}

}  // namespace slidewave::foam
