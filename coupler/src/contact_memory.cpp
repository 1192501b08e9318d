#include "contact_memory.hpp"

#include "slidewave/physics/contact_secant.hpp"

namespace slidewave {
namespace {

constexpr int force_row = 4;
constexpr int stiffness_row = 7;
/// A travel below this share of the radius is round-off of a grain at rest.
constexpr double least_travel = 1e-9;

}  // namespace

void recall_contacts(Table const& particles, double last_window_s, Vec3 const& gravity_m_s2,
                     Table& derived) {
  derived.resize(particles.size());
  auto const memory = particles["memory"];
  auto const travel = particles["travel"];
  auto const force = particles["other_force"];
  derived["other_force"] = force;
  if (last_window_s > 0) {
    derived["solid_velocity"] = travel / last_window_s;
  } else {
    derived["solid_velocity"] = particles["velocity"];
  }
  auto stiffness = derived["stiffness"];
  for (long i = 0; i < particles.size(); ++i) {
    Vec3 const weight = particles["mass"](0, i) * gravity_m_s2;
    double const contact = (force.col(i) - weight).norm();
    double const change = (force.col(i) - memory.col(i).segment<3>(force_row)).norm();
    double const way = travel.col(i).norm();
    bool const at_rest = way < least_travel * particles["radius"](0, i);
    stiffness(0, i) = contact_stiffness(memory(stiffness_row, i), change, contact,
                                        at_rest ? 0 : way, particles["stiffest"](0, i));
  }
}

void keep_contacts(Table const& derived, Table& answers) {
  auto memory = answers["memory"];
  memory.middleRows<3>(force_row) = derived["other_force"];
  memory.row(stiffness_row) = derived["stiffness"].row(0);
}

}  // namespace slidewave
