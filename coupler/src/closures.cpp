#include "closures.hpp"

#include <algorithm>
#include <cmath>

#include "slidewave/physics/brown_lawler.hpp"
#include "slidewave/physics/clump.hpp"
#include "slidewave/physics/di_felice.hpp"

namespace slidewave {

double volume_of(double radius_m) {
  return 4 * M_PI / 3 * radius_m * radius_m * radius_m;
}

void evaluate_drag(Models const& models, Table& particles) {
  auto const velocity = particles["velocity"];
  auto const fluid_velocity = particles["fluid_velocity"];
  auto const density = particles["density"];
  auto const viscosity = particles["viscosity"];
  auto const radius = particles["radius"];
  double const* void_fraction = models.porosity() ? particles["void_fraction"].data() : nullptr;
  auto drag = particles["drag"];
  double const grains = grains_per_particle(models.coarse_grain);
  for (long i = 0; i < particles.size(); ++i) {
    Grain grain;
    grain.diameter_m = grain_diameter(2 * radius(0, i), models.coarse_grain);
    grain.slip_m_s = (fluid_velocity.col(i) - velocity.col(i)).norm();
    grain.density_kg_m3 = density(0, i);
    grain.viscosity_Pa_s = viscosity(0, i);
    grain.void_fraction = void_fraction ? std::clamp(void_fraction[i], 0.25, 1.0) : 1.0;
    drag(0, i) = grains * in_formulation(models.formulation, DiFelice<BrownLawler>::drag(grain),
                                         grain.void_fraction);
  }
}

void evaluate_force(Table& particles) {
  auto const gradient = particles["pressure_gradient"];
  auto const radius = particles["radius"];
  auto force = particles["force"];
  for (long i = 0; i < particles.size(); ++i) {
    force.col(i) = -volume_of(radius(0, i)) * gradient.col(i);
  }
}

}  // namespace slidewave
