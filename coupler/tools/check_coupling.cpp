// The window between two exchanges: drag stiffness, added mass, particles crossing cells.
#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "slidewave/physics/added_mass.hpp"
#include "slidewave/physics/drag_models.hpp"
#include "slidewave/physics/limits/added_mass_number.hpp"
#include "slidewave/physics/limits/concurrent.hpp"
#include "slidewave/physics/limits/courant.hpp"
#include "slidewave/physics/limits/drag_response.hpp"
#include "slidewave/physics/limits/skeleton_wave.hpp"

namespace slidewave::preflight {
namespace {

constexpr double usual_solid_fraction = 0.6;

struct Fluid {
  double density_kg_m3;
  double viscosity_Pa_s;
};

Fluid denser(Facts const& facts) {
  return {facts.number("fluid_density_kg_m3"), facts.number("fluid_viscosity_Pa_s")};
}

/// K [kg/s] of the smallest particle with the case's own law.
double drag_of(Facts const& facts, Fluid const& fluid, double slip_m_s, double eps) {
  DragModel const model =
      drag_model(facts.text("drag", "di_felice"), facts.text("drag_coefficient", "brown_lawler"),
                 facts.text("formulation", "A"));
  auto const one = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value).eval(); };
  Eigen::MatrixXd fluid_velocity = Eigen::MatrixXd::Zero(3, 1);
  fluid_velocity(0, 0) = slip_m_s;
  Eigen::MatrixXd const radius = one(facts.number("diameter_min_m") / 2),
                        rest = Eigen::MatrixXd::Zero(3, 1), density = one(fluid.density_kg_m3),
                        viscosity = one(fluid.viscosity_Pa_s), voids = one(eps);
  Eigen::MatrixXd drag(1, 1);
  drag_coefficients(
      model,
      {facts.number("coarse_grain", 1), radius, rest, fluid_velocity, density, viscosity, voids},
      drag);
  return drag(0, 0);
}

/// K in a packed bed at the slip at which drag carries the weight of the submerged particle: a bed
/// that is swept faster flies apart.
double packed_drag(Facts const& facts, Fluid const& fluid, double eps, double largest_slip) {
  double const weight = eps * sphere_volume(facts.number("diameter_min_m")) *
                        std::abs(facts.number("particle_density_min_kg_m3") - fluid.density_kg_m3) *
                        facts.number("gravity_m_s2", 9.81);
  double low = 0, high = largest_slip;
  for (int i = 0; i < 60; ++i) {
    double const slip = (low + high) / 2;
    (drag_of(facts, fluid, slip, eps) * slip < weight ? low : high) = slip;
  }
  return drag_of(facts, fluid, high, eps);
}

bool stiff(Facts const& facts) {
  return facts.text("regime", "mild") == "stiff" && facts.flag("two_way", true);
}

/// The user's word that no particle is free: the fluid need not follow what does not move.
bool held(Facts const& facts) {
  return facts.flag("held", false);
}

bool concurrent(Facts const& facts) {
  return facts.text("scheme", "serial") == "concurrent" && facts.flag("two_way", true);
}

/// The drag of the smallest particle where it is largest.
struct Response {
  double drag_kg_s;
  double mass_kg;
  double solid_fraction;
  double x;  ///< K W/m
};

Response response_of(Facts const& facts, Fluid const& fluid) {
  double const slip = facts.has("slip_m_s") ? facts.number("slip_m_s") : facts.number("speed_m_s");
  // One-way, the law sees no void fraction.
  double const phi = facts.flag("two_way", true) ? solid_fraction(facts) : 0;
  double const mass =
      facts.number("particle_density_min_kg_m3") * sphere_volume(facts.number("diameter_min_m"));
  double const drag =
      std::max(drag_of(facts, fluid, slip, 1), packed_drag(facts, fluid, 1 - phi, slip));
  return {drag, mass, phi, limits::stiffness(drag, facts.number("window_s"), mass)};
}

/// Whether the facts tell enough; else the sheet names what is missing.
bool tells_response(Facts const& facts, Sheet& sheet, std::string const& quantity) {
  if (!sheet.needs(facts, quantity,
                   {"window_s", "diameter_min_m", "particle_density_min_kg_m3",
                    "fluid_density_kg_m3", "fluid_viscosity_Pa_s"})) {
    return false;
  }
  if (!facts.has("slip_m_s") && !facts.has("speed_m_s")) {
    sheet.left_out(quantity, "not known: slip_m_s or speed_m_s");
    return false;
  }
  return true;
}

void check_stiffness(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "response of the drag in a window, K W/m";
  if (!tells_response(facts, sheet, quantity)) {
    return;
  }
  bool const two_way = facts.flag("two_way", true);
  auto const [drag, mass, phi, x] = response_of(facts, denser(facts));
  double const window = facts.number("window_s");
  double const loading = limits::loading(phi, facts.number("particle_density_min_kg_m3"),
                                         facts.number("fluid_density_kg_m3"));
  // A fluid that hardly feels the particles cannot answer them wrongly: only the mixture must be
  // mild then, and one-way nothing must.
  bool const answers = two_way && (x * loading > limits::mild_stiffness || concurrent(facts));
  double const largest = concurrent(facts) ? limits::mild_stiffness
                         : held(facts)     ? limits::largest_held_mild_stiffness
                                           : limits::largest_mild_stiffness(phi);
  double const comfort =
      std::min(largest, phi > limits::dense_solid_fraction ? limits::dense_mild_stiffness
                                                           : limits::mild_stiffness);
  if (stiff(facts)) {
    sheet.at_most(quantity, x, limits::largest_stiffness, limits::largest_stiffness,
                  "proven range of the stiff regime",
                  {"coupling.window", window * limits::largest_stiffness / x});
  } else {
    sheet.at_most(quantity, x, comfort, answers ? largest : INFINITY,
                  "proven range of the mild regime; coupling.regime = \"stiff\" goes to 1e9",
                  {"coupling.window", window * comfort / x});
  }
  if (two_way) {
    double const mixture = limits::mixture_stiffness(x, loading);
    sheet.at_most("relaxation of the mixture, K W/m (1 + loading)", mixture,
                  limits::accurate_mixture_stiffness, INFINITY,
                  "rate of a free suspension right within a tenth",
                  {"coupling.window", window * limits::accurate_mixture_stiffness / mixture});
  }
  if (facts.has("dem_dt_s")) {
    sheet.note("response of the drag in a particle step, K dt/m",
               limits::stiffness(drag, facts.number("dem_dt_s"), mass),
               "the exponential kick is exact at any");
  }
}

/// What the drag takes from the fluid of a cell in a window, of either fluid.
void check_concurrent(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "drag on the fluid of a cell in a window, K W/m_fluid";
  if (!concurrent(facts) || !tells_response(facts, sheet, quantity)) {
    return;
  }
  std::vector<Fluid> fluids{denser(facts)};
  if (facts.has("second_density_kg_m3")) {
    if (!sheet.needs(facts, quantity, {"second_viscosity_Pa_s"})) {
      return;
    }
    fluids.push_back({facts.number("second_density_kg_m3"), facts.number("second_viscosity_Pa_s")});
  }
  double most = 0;
  for (Fluid const& fluid : fluids) {
    Response const response = response_of(facts, fluid);
    double const loading = limits::loading(
        response.solid_fraction, facts.number("particle_density_min_kg_m3"), fluid.density_kg_m3);
    most = std::max(most, limits::fluid_stiffness(response.x, loading));
  }
  double const limit = limits::concurrent_fluid_stiffness;
  sheet.at_most(quantity, most, limit, limit,
                "concurrent: beyond it slips ring; coupling.scheme = \"serial\" has no such limit",
                {"coupling.window", facts.number("window_s") * limit / most});
}

/// Stiff regime with drag strong enough to damp what the lag of the added mass feeds.
bool drag_damps(Facts const& facts, double from_stiffness) {
  Sheet unseen;
  return stiff(facts) && facts.text("drag", "di_felice") != "none" &&
         tells_response(facts, unseen, "") && response_of(facts, denser(facts)).x >= from_stiffness;
}

/// C of virtual mass in the densest part.
double virtual_mass(Facts const& facts) {
  std::string const law = facts.text("virtual_mass", "none");
  return law == "none"    ? 0
         : law == "zuber" ? added_mass_coefficient(1 - solid_fraction(facts))
                          : added_mass_coefficient(1);
}

double added_mass_of(Facts const& facts) {
  return limits::added_mass_number(solid_fraction(facts),
                                   facts.number("particle_density_min_kg_m3"),
                                   facts.number("fluid_density_kg_m3"), virtual_mass(facts),
                                   facts.text("formulation", "A") == "A");
}

void check_added_mass(Facts const& facts, Sheet& sheet) {
  std::string const quantity = virtual_mass(facts) > 0 ? "added-mass number, with virtual mass"
                                                       : "added-mass number rho_f phi/(rho_s eps)";
  if (!facts.flag("two_way", true)) {
    sheet.left_out(quantity, "one-way: the fluid does not see the particles");
    return;
  }
  if (held(facts)) {
    sheet.left_out(quantity, "check.held: no particle is free to move");
    return;
  }
  if (sheet.needs(facts, quantity, {"particle_density_min_kg_m3", "fluid_density_kg_m3"})) {
    double const comfort = stiff(facts) ? limits::comfortable_stiff_added_mass_number
                                        : limits::comfortable_added_mass_number;
    double const limit = concurrent(facts) ? limits::concurrent_added_mass_number
                         : drag_damps(facts, limits::damping_stiffness)
                             ? limits::stiff_added_mass_number
                             : limits::mild_added_mass_number;
    double const number = added_mass_of(facts);
    Remedy remedy{"parameters.particle_density",
                  facts.number("particle_density_min_kg_m3") * number / comfort};
    if (virtual_mass(facts) > 0) {
      remedy = {"models.virtual_mass", {}};
    }
    sheet.at_most(quantity, number, comfort, limit, "inertia that comes back a window late",
                  remedy);
  }
}

void check_waves(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "kernels that a contact wave runs in a window";
  if (!facts.flag("two_way", true) ||
      !sheet.needs(facts, quantity,
                   {"window_s", "smoothing_length_m", "stiffness_N_m", "diameter_min_m",
                    "diameter_max_m", "particle_density_min_kg_m3", "fluid_density_kg_m3"})) {
    return;
  }
  if (held(facts)) {
    sheet.left_out(quantity, "check.held: no particle is free to move");
    return;
  }
  if (drag_damps(facts, limits::damping_stiffness)) {
    sheet.left_out(quantity, "stiff regime: drag damps them");
    return;
  }
  double const density = facts.number("particle_density_min_kg_m3");
  double const fed = added_mass_of(facts);
  if (fed < limits::feeding_added_mass_number) {
    sheet.left_out(quantity, "the fluid is too light to feed them");
    return;
  }
  double const diameter = (facts.number("diameter_min_m") + facts.number("diameter_max_m")) / 2;
  double const speed =
      limits::skeleton_wave_speed(diameter, density * sphere_volume(diameter),
                                  contact_scale(facts).stiffness * facts.number("stiffness_N_m"));
  double const window = facts.number("window_s");
  double const run = limits::wave_run(speed, window, facts.number("smoothing_length_m"));
  double const serial = limits::largest_wave_run(fed);
  double const largest = concurrent(facts) ? limits::largest_concurrent_wave_run : serial;
  double const comfort = concurrent(facts) ? limits::comfortable_concurrent_wave_run
                                           : limits::comfortable_wave_share * serial;
  sheet.at_most(quantity, run, comfort, largest,
                "added mass that acts windows late feeds faster waves",
                {"coupling.window", window * comfort / run});
}

void check_crossing(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "cells crossed in a window";
  if (!facts.has("dem_dt_s") && !facts.has("diameter_min_m")) {
    sheet.left_out(quantity, "no particles");
    return;
  }
  if (sheet.needs(facts, quantity, {"window_s", "speed_m_s", "cell_size_m"})) {
    double const cell = facts.number("cell_size_m");
    double const speed = facts.number("speed_m_s");
    double const works = limits::courant_step(limits::largest_crossing, speed, cell);
    sheet.at_most(quantity, limits::courant(speed, facts.number("window_s"), cell),
                  limits::largest_crossing, 1, "void fraction moves with the particles",
                  {"coupling.window", works});
  }
}

void check_surface(Facts const& facts, Sheet& sheet) {
  if (!facts.has("second_density_kg_m3") || !facts.flag("two_way", true)) {
    return;
  }
  std::string const quantity = "kernels crossed in a window, at the surface";
  if (sheet.needs(facts, quantity, {"window_s", "speed_m_s", "smoothing_length_m"})) {
    double const length = facts.number("smoothing_length_m");
    double const speed = facts.number("speed_m_s");
    sheet.at_most(
        quantity, limits::courant(speed, facts.number("window_s"), length),
        limits::largest_crossing, INFINITY,
        "drag and buoyancy change from one fluid's to the other's",
        {"coupling.window", limits::courant_step(limits::largest_crossing, speed, length)});
  }
}

/// The longest window at which all above is ok, made a whole part of the run.
void suggest_window(Facts const& facts, Sheet& sheet) {
  double const longest = sheet.longest_window_s();
  if (!facts.has("end_time_s") || std::isinf(longest)) {
    sheet.left_out("suggested window [s]", "nothing limits it, or not known: end_time_s");
    return;
  }
  double const end = facts.number("end_time_s");
  sheet.note("suggested window [s]", end / std::ceil(end / longest * (1 - 1e-9)),
             "the longest at which every row that it decides is ok");
}

}  // namespace

double solid_fraction(Facts const& facts) {
  if (facts.has("solid_fraction")) {
    return facts.number("solid_fraction");
  }
  if (!facts.has("particles") || !facts.has("diameter_max_m") || !facts.has("smoothing_length_m")) {
    return usual_solid_fraction;
  }
  // Few particles, all in one place: what their kernel exp(-r^2/L^2) makes of their volume.
  double const kernel = std::pow(M_PI, 1.5) * std::pow(facts.number("smoothing_length_m"), 3);
  return std::min(usual_solid_fraction, facts.number("particles") *
                                            sphere_volume(facts.number("diameter_max_m")) / kernel);
}

void check_coupling(Facts const& facts, Sheet& sheet) {
  if (facts.text("drag", "di_felice") == "none") {
    sheet.left_out("response of the drag", "models.drag = \"none\"");
  } else {
    check_stiffness(facts, sheet);
    check_concurrent(facts, sheet);
  }
  check_added_mass(facts, sheet);
  check_waves(facts, sheet);
  check_crossing(facts, sheet);
  check_surface(facts, sheet);
  suggest_window(facts, sheet);
}

}  // namespace slidewave::preflight
