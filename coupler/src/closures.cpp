#include "closures.hpp"

#include <cmath>
#include <utility>

#include "slidewave/physics/volume_forces.hpp"

namespace slidewave {

double volume_of(double radius_m) {
  return 4 * M_PI / 3 * radius_m * radius_m * radius_m;
}

void evaluate_drag(Models const& models, Table& particles) {
  Table const& read = particles;
  Eigen::MatrixXd const none;
  auto const run = [&](Rows const& void_fraction) {
    drag_coefficients(models.drag_model,
                      {models.coarse_grain, read["radius"], read["velocity"],
                       read["fluid_velocity"], read["density"], read["viscosity"], void_fraction},
                      particles["drag"]);
  };
  if (models.porosity()) {
    run(read["void_fraction"]);
  } else {
    run(none);
  }
}

void evaluate_force(Table& particles) {
  auto const radius = std::as_const(particles)["radius"];
  auto force = particles["force"];
  for (long i = 0; i < particles.size(); ++i) {
    Vec3 const gradient = force.col(i);
    force.col(i) = pressure_gradient_force(volume_of(radius(0, i)), gradient);
  }
}

}  // namespace slidewave
