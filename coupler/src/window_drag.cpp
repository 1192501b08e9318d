#include "window_drag.hpp"

#include <algorithm>
#include <utility>

#include "slidewave/physics/window_response.hpp"

namespace slidewave {
namespace {

/// As in the closures: denser than this no law holds.
constexpr double least_void_fraction = 0.25;

double bounded(double void_fraction) {
  return std::clamp(void_fraction, least_void_fraction, 1.0);
}

}  // namespace

void foresee(double window_s, Vec3 const& gravity_m_s2, RowRange rows, Table& particles) {
  Table const& read = particles;
  auto response = particles["response"];
  auto repaid = particles["ledger"];  // a force by now
  if (window_s <= 0) {
    response.middleCols(rows.begin, rows.count).setZero();
    repaid.middleCols(rows.begin, rows.count).setZero();
    return;
  }
  auto const drag = read["drag"], mass = read["mass"], stiffness = read["stiffness"],
             density = read["density"], radius = read["radius"], voids = read["void_fraction"];
  auto const velocity = read["velocity"], fluid = read["fluid_velocity"],
             solid = read["solid_velocity"], others = read["other_force"];
  for (long i = rows.begin; i < rows.end(); ++i) {
    double const eps = bounded(voids(0, i)), phi = 1 - eps;
    double const to_fluid = drag(0, i) / eps;      // K'
    double const to_solid = to_fluid * phi / eps;  // K_a
    double const both = to_fluid + to_solid;       // K_e
    WindowResponse const y = window_response(mass(0, i), both, stiffness(0, i), window_s);
    // Fluid that speeds up takes the grain's volume along: rho V du/dt acts on it too.
    double const displaced_kg = density(0, i) * volume_of(radius(0, i));
    double const inertia = displaced_kg / window_s;
    Vec3 const push = to_solid * solid.col(i) + others.col(i) - displaced_kg * gravity_m_s2 -
                      inertia * fluid.col(i);
    // Impulse received = linear u + rest.
    double const linear = to_fluid * window_s - both * y.force_m_N * (to_fluid + inertia);
    Vec3 const rest = to_solid * window_s * solid.col(i) -
                      both * (y.velocity_s * velocity.col(i) + y.force_m_N * push);
    response(0, i) = eps * linear / window_s;
    repaid.col(i) = eps * (repaid.col(i) - rest / window_s) - response(0, i) * velocity.col(i);
  }
}

void answer_in_kick_form(double window_s, Vec3 const& in_plane, Table& particles) {
  Table const& read = particles;
  auto const reaction = read["drag_reaction"], solid = read["solid_velocity"],
             radius = read["radius"], voids = read["void_fraction"];
  auto drag = particles["drag"], fluid = particles["fluid_velocity"], force = particles["force"],
       given = particles["given"];
  for (long i = 0; i < particles.size(); ++i) {
    double const eps = bounded(voids(0, i));
    Vec3 const taken_out = volume_of(radius(0, i)) * in_plane.cwiseProduct(reaction.col(i));
    force.col(i) -= taken_out;
    given.col(i) += window_s * taken_out;
    drag(0, i) /= eps * eps;
    fluid.col(i) = eps * fluid.col(i) + (1 - eps) * solid.col(i);
  }
}

}  // namespace slidewave
