// Mesh and fluid step: cells against particles and kernel, Courant numbers, surface tension.
#include <cmath>

#include "checks.hpp"
#include "slidewave/physics/limits/capillary.hpp"
#include "slidewave/physics/limits/courant.hpp"
#include "slidewave/physics/limits/gravity_wave.hpp"
#include "slidewave/physics/limits/resolution.hpp"

namespace slidewave::preflight {
namespace {

/// Cells below this share of the usual one set the time step for all.
constexpr double smallest_cell_share = 0.3;

bool two_fluids(Facts const& facts) {
  return facts.has("second_density_kg_m3");
}

double courant_limit(Facts const& facts) {
  return two_fluids(facts) ? limits::largest_interface_courant : limits::largest_courant;
}

void check_courant(Facts const& facts, Sheet& sheet) {
  std::string const quantity = two_fluids(facts) ? "interface Courant number" : "Courant number";
  if (!sheet.needs(facts, quantity, {"speed_m_s", "cell_size_m"})) {
    return;
  }
  double const speed = facts.number("speed_m_s");
  double const cell = facts.number("smallest_cell_m", facts.number("cell_size_m"));
  double const step = limits::courant_step(courant_limit(facts), speed, cell);
  if (facts.has("fluid_dt_s")) {
    sheet.at_most(quantity, limits::courant(speed, facts.number("fluid_dt_s"), cell),
                  courant_limit(facts), 1, "at the expected speed in the smallest cell",
                  {"parameters.fluid_dt", step});
  } else if (facts.has("window_s")) {
    sheet.note("fluid steps in a window, at least", std::ceil(facts.number("window_s") / step),
               "adaptive step at the expected speed in the smallest cell");
  }
}

void check_gravity_waves(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "turn of the shortest gravity wave in a fluid step";
  if (!two_fluids(facts) || !sheet.needs(facts, quantity, {"cell_size_m"})) {
    return;
  }
  double const cell = facts.number("smallest_cell_m", facts.number("cell_size_m"));
  double const rate = limits::shortest_wave_rate(facts.number("gravity_m_s2", 9.81), cell);
  // An adaptive step may grow to the whole window.
  double const step = facts.number("fluid_dt_s", facts.number("window_s", 0));
  std::string const key = facts.has("fluid_dt_s") ? "parameters.fluid_dt" : "coupling.window";
  if (rate > 0) {
    sheet.at_most(quantity, rate * step, limits::comfortable_wave_turn, limits::largest_wave_turn,
                  "the surface's weight acts with the level of the step's start",
                  {key, limits::comfortable_wave_turn / rate});
  }
}

void check_capillary(Facts const& facts, Sheet& sheet) {
  if (facts.number("surface_tension_N_m", 0) <= 0) {
    return;
  }
  std::string const quantity = "fluid step over capillary step";
  if (sheet.needs(facts, quantity,
                  {"fluid_density_kg_m3", "second_density_kg_m3", "cell_size_m"})) {
    double const cell = facts.number("smallest_cell_m", facts.number("cell_size_m"));
    double const capillary = limits::capillary_step(facts.number("fluid_density_kg_m3"),
                                                    facts.number("second_density_kg_m3"), cell,
                                                    facts.number("surface_tension_N_m"));
    if (!facts.has("fluid_dt_s")) {
      sheet.note("largest fluid step with surface tension [s]", capillary, "capillary waves");
      return;
    }
    sheet.at_most(quantity, facts.number("fluid_dt_s") / capillary, 0.7, 1, "capillary waves",
                  {"parameters.fluid_dt", 0.7 * capillary});
  }
}

void check_cells(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "cell size over diameter";
  if (sheet.needs(facts, quantity, {"cell_size_m", "diameter_min_m", "diameter_max_m"})) {
    double const cell = facts.number("cell_size_m");
    double const fine = facts.number("diameter_max_m");
    sheet.at_least("cell size over largest diameter", limits::cell_per_diameter(cell, fine),
                   limits::smallest_cell_per_diameter * (1 - 1e-9),
                   limits::smallest_cell_per_diameter * (1 - 1e-9),
                   "void fraction of unresolved particles",
                   {"parameters.cell", limits::smallest_cell_per_diameter * fine});
    double const coarse = facts.number("diameter_min_m");
    sheet.at_most("cell size over smallest diameter", limits::cell_per_diameter(cell, coarse),
                  limits::largest_cell_per_diameter, INFINITY, "resolution of the void fraction",
                  {"parameters.cell", limits::largest_cell_per_diameter * coarse});
  }
  if (facts.has("smallest_cell_m") && facts.has("cell_size_m")) {
    sheet.at_least("smallest over usual cell",
                   facts.number("smallest_cell_m") / facts.number("cell_size_m"),
                   smallest_cell_share, 0, "thin cells set the fluid step for all", {"", {}});
  }
}

void check_smoothing(Facts const& facts, Sheet& sheet) {
  std::string const quantity = "smoothing length [m]";
  if (!facts.flag("two_way", true)) {
    sheet.left_out(quantity, "one-way: no void fraction");
    return;
  }
  if (sheet.needs(facts, quantity, {"smoothing_length_m", "diameter_max_m", "cell_size_m"})) {
    double const length =
        limits::smoothing_length(facts.number("diameter_max_m"), facts.number("cell_size_m"));
    sheet.at_least(quantity, facts.number("smoothing_length_m"), length * (1 - 1e-9),
                   length * limits::shortest_smoothing_share * (1 - 1e-9),
                   "1.5 largest diameters and 1.5 cells", {"coupling.smoothing_length", length});
  }
}

}  // namespace

void check_fluid(Facts const& facts, Sheet& sheet) {
  if (!facts.has("cells") && !facts.has("cell_size_m")) {
    sheet.left_out("mesh and fluid step", "no mesh");
    return;
  }
  check_cells(facts, sheet);
  check_smoothing(facts, sheet);
  check_courant(facts, sheet);
  check_gravity_waves(facts, sheet);
  check_capillary(facts, sheet);
}

}  // namespace slidewave::preflight
