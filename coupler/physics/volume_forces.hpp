// Forces on a particle that go with its volume, coarse-grained or not. Formulation A takes the
// pressure gradient (hydrostatics included) and may take the viscous stress; B takes Archimedes.
// Pressure gradient and Archimedes together count buoyancy twice: choose one (PHYSICS.md 1.3).
#pragma once

#include <Eigen/Core>

namespace slidewave {

/// -V grad p [N].
inline Eigen::Vector3d pressure_gradient_force(double volume_m3,
                                               Eigen::Vector3d const& gradient_Pa_m) {
  return -volume_m3 * gradient_Pa_m;
}

/// V div tau [N] of the fluid's viscous stress tau.
inline Eigen::Vector3d viscous_force(double volume_m3, Eigen::Vector3d const& divergence_N_m3) {
  return volume_m3 * divergence_N_m3;
}

/// -rho V g [N].
inline Eigen::Vector3d archimedes_force(double volume_m3, double fluid_density_kg_m3,
                                        Eigen::Vector3d const& gravity_m_s2) {
  return -fluid_density_kg_m3 * volume_m3 * gravity_m_s2;
}

}  // namespace slidewave
