#include <algorithm>
#include <cmath>

#include "StepSize.H"
#include "fvc.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace slidewave::foam {

using namespace Foam;

StepSize::StepSize(Time const& time)
    : adjust_(time.controlDict().lookupOrDefault("adjustTimeStep", false)),
      wanted_s_(time.deltaTValue()),
      maxCourant_(time.controlDict().lookupOrDefault<scalar>("maxCo", 1)),
      maxInterfaceCourant_(time.controlDict().lookupOrDefault<scalar>("maxAlphaCo", maxCourant_)),
      longest_s_(time.controlDict().lookupOrDefault<scalar>("maxDeltaT", GREAT)) {}

double StepSize::next(double now_s, double end_s, double courant, double interfaceCourant,
                      double courantStep_s) {
  if (adjust_) {
    double const allowed = std::min(maxCourant_ / (courant + SMALL),
                                    maxInterfaceCourant_ / (interfaceCourant + SMALL));
    wanted_s_ = std::min({allowed * courantStep_s, 1.2 * wanted_s_, longest_s_});
  }
  double const left_s = end_s - now_s;
  double const steps = std::ceil(left_s / wanted_s_ * (1 - 1e-9));
  double const step_s = left_s / std::max(steps, 1.0);
  // A fixed step that divides the window stays what the case says, to the last digit.
  return !adjust_ && std::abs(step_s - wanted_s_) < 1e-9 * wanted_s_ ? wanted_s_ : step_s;
}

double courantNumber(surfaceScalarField const& flux, volScalarField const& eps,
                     scalarField const& target, double dt_s, scalarField const* weight) {
  scalarField sum(fvc::surfaceSum(mag(flux))().primitiveField());
  if (weight) sum *= *weight;
  scalarField const pores(min(eps.primitiveField(), target) * eps.mesh().V().field());
  return 0.5 * dt_s * gMax((sum / pores)());
}

}  // namespace slidewave::foam
