// Closures over the particles of a fluid rank, through the headers of slidewave/physics.
#pragma once

#include "models.hpp"
#include "slidewave/table.hpp"

namespace slidewave {

/// drag [kg/s] from velocity, fluid_velocity, density, viscosity, radius and (with porosity)
/// void_fraction.
void evaluate_drag(Models const& models, Table& particles);

/// force [N] = -V grad p from radius and grad p [Pa/m], which `force` holds before.
void evaluate_force(Table& particles);

double volume_of(double radius_m);

}  // namespace slidewave
