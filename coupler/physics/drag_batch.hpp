// Drag coefficients of many particles with one law: no allocation, the law inlined in the loop.
// (Packs of 16 through Eigen's SSE2 exp and log were tried: 68 ns a particle against 45.)
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "slidewave/physics/clump.hpp"
#include "slidewave/physics/grain.hpp"

namespace slidewave {

/// Below this the laws are extrapolated out of all reason: they are evaluated at the floor.
constexpr double closure_void_fraction_floor = 0.25;

using Rows = Eigen::Ref<Eigen::MatrixXd const>;

/// Columns of n particles (components x n, as in Table). An empty void_fraction means 1.
struct DragInputs {
  double alpha;         ///< coarse-graining factor D/d
  Rows radius_m;        ///< of the particles: D/2
  Rows velocity_m_s;    ///< of the particles, 3 x n
  Rows fluid_velocity;  ///< interstitial [m/s], 3 x n
  Rows density_kg_m3;   ///< of the fluid at the particles
  Rows viscosity_Pa_s;
  Rows void_fraction;
  double const* type = nullptr;           ///< of each particle, from 1; null: one alpha for all
  double const* alpha_of_type = nullptr;  ///< instead of alpha where there are types
};

/// Writes K [kg/s] of each particle: alpha^3 times that of a grain of diameter D/alpha.
template <class Law>
void drag_coefficients_of(DragInputs const& in, Formulation formulation,
                          Eigen::Ref<Eigen::MatrixXd> drag_kg_s) {
  bool const porous = in.void_fraction.size() > 0;
  for (Eigen::Index i = 0; i < in.radius_m.cols(); ++i) {
    double const x = in.fluid_velocity(0, i) - in.velocity_m_s(0, i);
    double const y = in.fluid_velocity(1, i) - in.velocity_m_s(1, i);
    double const z = in.fluid_velocity(2, i) - in.velocity_m_s(2, i);
    double const eps =
        porous ? std::clamp(in.void_fraction(0, i), closure_void_fraction_floor, 1.0) : 1.0;
    double const alpha = in.type ? in.alpha_of_type[static_cast<int>(in.type[i]) - 1] : in.alpha;
    double const grains = grains_per_particle(alpha);
    Grain const grain{grain_diameter(2 * in.radius_m(0, i), alpha),
                      std::sqrt(x * x + y * y + z * z), in.density_kg_m3(0, i),
                      in.viscosity_Pa_s(0, i), eps};
    drag_kg_s(0, i) = in_formulation(formulation, grains * Law::drag(grain), eps);
  }
}

}  // namespace slidewave
