// Memory, core time, and how to split the ranks.
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "slidewave/physics/limits/cost.hpp"
#include "slidewave/physics/limits/courant.hpp"
#include "slidewave/physics/nearest_name.hpp"

namespace slidewave::preflight {
namespace {

limits::UnitCosts unit_costs(Facts const& facts) {
  limits::UnitCosts costs;
  costs.particle_steps_per_s = facts.number("particle_steps_per_s", costs.particle_steps_per_s);
  costs.cell_steps_per_s = facts.number("cell_steps_per_s", costs.cell_steps_per_s);
  return costs;
}

/// Fluid steps of the run: the fixed step, or windows cut by the Courant number.
double fluid_steps(Facts const& facts, double end_time) {
  if (facts.has("fluid_dt_s")) {
    return end_time / facts.number("fluid_dt_s");
  }
  double step = facts.number("window_s", end_time);
  if (facts.has("speed_m_s") && facts.has("cell_size_m")) {
    step = std::min(
        step, limits::courant_step(limits::largest_interface_courant, facts.number("speed_m_s"),
                                   facts.number("smallest_cell_m", facts.number("cell_size_m"))));
  }
  return end_time / step;
}

void check_memory(Facts const& facts, Sheet& sheet) {
  double const installed = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  double const available = facts.number("memory_available_bytes", installed);
  double const needed = limits::memory_bytes(unit_costs(facts), facts.number("particles", 0),
                                             facts.number("cells", 0), facts.number("ranks", 2));
  sheet.at_most("memory [GB]", needed / 1e9, 0.7 * available / 1e9, available / 1e9,
                "bytes a particle, cell and rank; this machine", {"", {}});
}

void check_time(Facts const& facts, Sheet& sheet) {
  if (!facts.has("end_time_s")) {
    sheet.left_out("core time [s]", "not known: end_time_s");
    return;
  }
  auto const costs = unit_costs(facts);
  double const end = facts.number("end_time_s");
  char const* const particle_cost = facts.has("particle_steps_per_s")
                                        ? "calibrated on this machine"
                                        : "usual cost of a particle-step";
  char const* const cell_cost = facts.has("cell_steps_per_s") ? "calibrated on this machine"
                                                              : "usual cost of a cell and step";
  double particles = 0;
  if (facts.has("dem_dt_s") && facts.has("particles")) {
    particles =
        limits::particle_seconds(costs, facts.number("particles"), end / facts.number("dem_dt_s"));
    sheet.note("core time of the particles [s]", particles, particle_cost);
  }
  double fluid = 0;
  if (facts.has("cells")) {
    fluid = limits::cell_seconds(costs, facts.number("cells"), fluid_steps(facts, end));
    sheet.note("core time of the fluid [s]", fluid, cell_cost);
  }
  double const ranks = facts.number("ranks", 2);
  if (particles > 0 && fluid > 0 && ranks >= 2) {
    double const share = std::round(ranks * fluid / (fluid + particles));
    sheet.note("suggested fluid ranks", std::clamp(share, 1.0, ranks - 1),
               "share of the core time");
  }
}

}  // namespace

void check_cost(Facts const& facts, Sheet& sheet) {
  check_memory(facts, sheet);
  check_time(facts, sheet);
}

void check_names(Facts const& facts, Sheet& sheet) {
  auto const& known = known_facts();
  for (auto const& name : facts.names()) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      std::string const nearest = nearest_name(name, known);
      sheet.left_out("fact " + name,
                     "unknown" + (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    }
  }
}

}  // namespace slidewave::preflight
