// Contacts and sizes: what the DEM engine's step, stiffness and periodic box must satisfy.
#include <cmath>

#include "checks.hpp"
#include "slidewave/physics/limits/contact_step.hpp"
#include "slidewave/physics/limits/overlap.hpp"
#include "slidewave/physics/limits/resolution.hpp"

namespace slidewave::preflight {
namespace {

double lightest_mass(Facts const& facts) {
  return facts.number("particle_density_min_kg_m3") * sphere_volume(facts.number("diameter_min_m"));
}

/// The step that divides the window and is at most `step`.
double dividing_step(Facts const& facts, double step) {
  if (!facts.has("window_s")) {
    return step;
  }
  double const window = facts.number("window_s");
  return window / std::ceil(window / step * (1 - 1e-12));
}

void check_step(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "particle step [s]";
  if (!sheet.needs(facts, quantity,
                   {"dem_dt_s", "stiffness_N_m", "diameter_min_m", "particle_density_min_kg_m3"})) {
    return;
  }
  double const factor = contact_scale(facts).stiffness;
  double const kn = factor * facts.number("stiffness_N_m");
  double const ks = factor * facts.number("tangential_stiffness_N_m", 0.9 * kn / factor);
  double const mass = lightest_mass(facts);
  double const critical = limits::critical_contact_step(
      mass, kn, ks, facts.number("contact_number", limits::usual_contact_number));
  double const step = facts.number("dem_dt_s");
  double const comfort = limits::comfortable_step_fraction * critical;
  sheet.at_most(quantity, step, comfort, limits::largest_step_fraction * critical,
                "three quarters of the critical step of the fastest contact mode",
                {"parameters.dem_dt", dividing_step(facts, comfort)});
  double const wanted = limits::steps_per_contact;
  sheet.at_least(
      "steps per contact", limits::contact_time(mass, kn) / step, wanted, 0,
      "duration of a collision of the smallest particles",
      {"parameters.dem_dt", dividing_step(facts, limits::contact_time(mass, kn) / wanted)});
}

void check_column(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "overlap under the column's weight [D]";
  if (!sheet.needs(facts, quantity,
                   {"column_height_m", "gravity_m_s2", "diameter_max_m", "stiffness_N_m",
                    "particle_density_min_kg_m3"})) {
    return;
  }
  double const bulk = solid_fraction(facts) * facts.number("particle_density_min_kg_m3");
  double const factor = contact_scale(facts).stiffness;
  double const kn = factor * facts.number("stiffness_N_m");
  double const overlap =
      limits::static_overlap(facts.number("column_height_m"), bulk, facts.number("gravity_m_s2"),
                             facts.number("diameter_max_m"), kn);
  sheet.at_most(quantity, overlap, limits::comfortable_overlap, limits::largest_overlap,
                "stress of the column over kn/D",
                {"parameters.kn",
                 limits::stiffness_for_static(overlap, limits::comfortable_overlap, kn) / factor});
}

void check_impact(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "overlap in the fastest impact [D]";
  if (!sheet.needs(
          facts, quantity,
          {"speed_m_s", "diameter_max_m", "stiffness_N_m", "particle_density_min_kg_m3"})) {
    return;
  }
  double const diameter = facts.number("diameter_max_m");
  double const mass = facts.number("particle_density_min_kg_m3") * sphere_volume(diameter);
  double const factor = contact_scale(facts).stiffness;
  double const kn = factor * facts.number("stiffness_N_m");
  double const overlap = limits::impact_overlap(facts.number("speed_m_s"), mass, diameter, kn);
  sheet.at_most(quantity, overlap, limits::largest_overlap, 2 * limits::largest_overlap,
                "collision of two of the largest at the expected speed",
                {"parameters.kn",
                 limits::stiffness_for_impact(overlap, limits::largest_overlap, kn) / factor});
}

void check_periodic(Facts const& facts, Sheet& sheet) {
  if (!facts.has("periodic_width_m")) {
    return;  // not periodic: nothing to say
  }
  std::string const quantity = "periodic width [m]";
  if (sheet.needs(facts, quantity, {"diameter_max_m"})) {
    bool const own = facts.text("contact_law", "packaged") == "own";
    double const least = limits::periodic_width(facts.number("diameter_max_m"), own);
    sheet.at_least(quantity, facts.number("periodic_width_m"), least * (1 - 1e-9),
                   least * (1 - 1e-9),
                   own ? "a largest diameter: no particle touches its own image"
                       : "two largest diameters: contact history by particle",
                   {"parameters.width", least});
  }
}

}  // namespace

ContactScale contact_scale(Facts const& facts) {
  return slidewave::contact_scale(contact_scaling(facts.text("contact_scaling", "none")),
                                  facts.number("coarse_grain", 1));
}

double sphere_volume(double diameter_m) {
  return M_PI / 6 * std::pow(diameter_m, 3);
}

void check_particles(Facts const& facts, Sheet& sheet) {
  check_step(facts, sheet);
  check_column(facts, sheet);
  check_impact(facts, sheet);
  check_periodic(facts, sheet);
}

}  // namespace slidewave::preflight
