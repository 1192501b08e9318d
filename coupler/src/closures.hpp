// Closures over the particles of a fluid rank, through the headers of slidewave/physics.
#pragma once

#include "models.hpp"
#include "slidewave/table.hpp"

namespace slidewave {

/// Rows [begin, end()) of the particles' table.
struct RowRange {
  long begin = 0;
  long count = 0;
  long end() const { return begin + count; }
  static RowRange all(Table const& particles) { return {0, particles.size()}; }
};

/// drag [kg/s] from velocity, fluid_velocity, density, viscosity, radius and (with porosity)
/// void_fraction.
void evaluate_drag(Models const& models, RowRange rows, Table& particles);

/// force [N]: the sum of -V grad p, V div tau and Archimedes' force, of those that are on. grad p
/// [Pa/m] is what `force` holds before.
void evaluate_force(Models const& models, Vec3 const& gravity_m_s2, Table& particles);

/// added_mass [kg] from density, radius and (with porosity) void_fraction.
void evaluate_added_mass(Models const& models, RowRange rows, Table& particles);
/// lift [N] from velocity, fluid_velocity, vorticity, density, viscosity and radius.
void evaluate_lift(Models const& models, RowRange rows, Table& particles);
/// Lift and added_mass x acceleration [N], of those that are on, into exchanged_force; one-way they
/// are added to force.
void push(Models const& models, Table& particles);

/// rotational_drag [N m s] and fluid_spin [rad/s] from vorticity, viscosity and radius.
void evaluate_torque(Models const& models, Table& particles);

double volume_of(double radius_m);

}  // namespace slidewave
