#include "closures.hpp"

#include <cmath>
#include <utility>

#include "slidewave/physics/added_mass.hpp"
#include "slidewave/physics/clump.hpp"
#include "slidewave/physics/rotational_drag.hpp"
#include "slidewave/physics/saffman_mei.hpp"
#include "slidewave/physics/volume_forces.hpp"

namespace slidewave {

double volume_of(double radius_m) {
  return 4 * M_PI / 3 * radius_m * radius_m * radius_m;
}

void evaluate_drag(Models const& models, RowRange rows, Table& particles) {
  Table const& read = particles;
  auto const some = [&](char const* name) { return read[name].middleCols(rows.begin, rows.count); };
  Eigen::MatrixXd const none;
  auto const run = [&](Rows const& void_fraction) {
    drag_coefficients(models.drag_model,
                      {models.coarse_grain, some("radius"), some("velocity"),
                       some("fluid_velocity"), some("density"), some("viscosity"), void_fraction,
                       models.by_type() ? read["type"].data() + rows.begin : nullptr,
                       models.coarse_grain_by_type.data()},
                      particles["drag"].middleCols(rows.begin, rows.count));
  };
  if (models.porosity()) {
    run(some("void_fraction"));
  } else {
    run(none);
  }
}

void evaluate_force(Models const& models, Vec3 const& gravity_m_s2, Table& particles) {
  Table const& read = particles;
  auto force = particles["force"];
  auto const radius = read["radius"];
  if (models.pressure_gradient) {
    for (long i = 0; i < particles.size(); ++i) {
      Vec3 const gradient = force.col(i);
      force.col(i) = pressure_gradient_force(volume_of(radius(0, i)), gradient);
    }
  } else {
    force.setZero();
  }
  auto const add = [&](bool on, char const* field, auto const& law) {
    if (on) {
      auto const values = read[field];
      for (long i = 0; i < particles.size(); ++i) {
        force.col(i) += law(volume_of(radius(0, i)), values.col(i));
      }
    }
  };
  add(models.viscous_force, "viscous_stress",
      [](double volume_m3, Vec3 const& stress) { return viscous_force(volume_m3, stress); });
  add(models.archimedes(), "density", [&](double volume_m3, auto const& density) {
    return archimedes_force(volume_m3, density[0], gravity_m_s2);
  });
}

void evaluate_added_mass(Models const& models, RowRange rows, Table& particles) {
  Table const& read = particles;
  auto mass = particles["added_mass"];
  auto const density = read["density"], radius = read["radius"];
  bool const dense = models.porosity() && models.virtual_mass == VirtualMass::zuber;
  double const* const voids = dense ? read["void_fraction"].data() : nullptr;
  for (long i = rows.begin; i < rows.end(); ++i) {
    double const eps = dense ? voids[i] : 1;
    mass(0, i) = added_mass(added_mass_coefficient(eps), density(0, i), volume_of(radius(0, i)));
  }
}

void evaluate_lift(Models const& models, RowRange rows, Table& particles) {
  Table const& read = particles;
  auto lift = particles["lift"];
  auto const radius = read["radius"], density = read["density"], viscosity = read["viscosity"];
  auto const fluid = read["fluid_velocity"], velocity = read["velocity"],
             vorticity = read["vorticity"];
  for (long i = rows.begin; i < rows.end(); ++i) {
    double const alpha = models.alpha(read, i), grains = grains_per_particle(alpha);
    double const diameter = grain_diameter(2 * radius(0, i), alpha);
    lift.col(i) = grains * saffman_mei_lift(diameter, density(0, i), viscosity(0, i),
                                            fluid.col(i) - velocity.col(i), vorticity.col(i));
  }
}

void push(Models const& models, Table& particles) {
  Table const& read = particles;
  auto to = particles[models.exchanged_force() ? "exchanged_force" : "force"];
  if (models.exchanged_force()) {
    to.setZero();
  }
  if (models.moves_fluid_along()) {
    to += read["acceleration"] * read["added_mass"].row(0).asDiagonal();
  }
  if (models.lift) {
    to += read["lift"];
  }
}

void evaluate_torque(Models const& models, Table& particles) {
  Table const& read = particles;
  auto drag = particles["rotational_drag"];
  auto const radius = read["radius"], viscosity = read["viscosity"];
  for (long i = 0; i < particles.size(); ++i) {
    double const alpha = models.alpha(read, i), grains = grains_per_particle(alpha);
    double const diameter = grain_diameter(2 * radius(0, i), alpha);
    drag(0, i) = grains * rotational_drag(diameter, viscosity(0, i));
  }
  particles["fluid_spin"] = 0.5 * read["vorticity"];
}

}  // namespace slidewave
