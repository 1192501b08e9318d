#include "summary.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "pass.hpp"

namespace slidewave {
namespace {

using Json = nlohmann::json;

bool starts_with(std::string const& text, std::string const& start) {
  return text.compare(0, start.size(), start) == 0;
}

bool ends_with(std::string const& text, std::string const& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// NaN is not JSON; null says that a number is missing.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// Means over the ranks of a side [s].
Json timings(double const* seconds, int ranks) {
  Json json;
  for (int k = 0; k < Profile::phases; ++k) {
    json[Profile::names[k]] = seconds[k] / std::max(1, ranks);
  }
  return json;
}

void note_extreme(std::map<std::string, double>& extremes, Quantity const& column, bool lowest) {
  auto const [entry, is_new] = extremes.emplace(column.name, column.value);
  if (!is_new) {
    entry->second =
        lowest ? std::min(entry->second, column.value) : std::max(entry->second, column.value);
  }
}

}  // namespace

std::string unit_of(std::string const& column) {
  for (auto const& [suffix, unit] : {std::pair{"_kg_m_s", "kg m/s"},
                                     {"_m_s", "m/s"},
                                     {"_kg_m3", "kg/m3"},
                                     {"_m3", "m3"},
                                     {"_m2", "m2"},
                                     {"_kg", "kg"},
                                     {"_Pa", "Pa"},
                                     {"_N", "N"},
                                     {"_J", "J"},
                                     {"_m", "m"},
                                     {"_s", "s"}}) {
    if (ends_with(column, suffix)) {
      return unit;
    }
  }
  return "-";
}

Summary::Summary(Session::Impl& session, Agreed const& agreed)
    : session_(session), agreed_(agreed) {}

void Summary::add(Window const& window, std::vector<Quantity> const& columns, DemSums const& dem,
                  FluidSums const& fluid) {
  windows_ = window.index;
  dem_ = dem;
  fluid_ = fluid;
  last_ = columns;
  for (Quantity const& column : columns) {
    std::string const& name = column.name;
    if (name == "momentum_defect" || name == "momentum_outstanding" || name == "particles_lost" ||
        name == "mass_lost_kg") {
      budgets_[name] = column.value;  // sums over the run, or the state at its end
    } else if (ends_with(name, "_defect")) {
      note_extreme(budgets_, {name, std::abs(column.value)}, false);
    } else if (starts_with(name, "max_") || name == "dem_step_fraction") {
      note_extreme(extremes_, column, false);
    } else if (starts_with(name, "min_")) {
      note_extreme(extremes_, column, true);
    }
    if (name == "momentum_outstanding") {
      note_extreme(budgets_, {"momentum_outstanding_max", column.value}, false);
    }
    if (name == "outside" || name == "nearest_cell") {
      note_extreme(budgets_, {name + "_max", column.value}, false);
    }
  }
}

void Summary::pass(State& state) {
  state.pass("summary.windows", windows_);
  state.pass("summary.cells", cells_);
  pass_sums(state, "summary.dem", dem_);
  pass_sums(state, "summary.fluid", fluid_);
  pass_columns(state, "summary.last", last_);
  pass_map(state, "summary.extremes", extremes_);
  pass_map(state, "summary.budgets", budgets_);
}

void Summary::write(std::string const& status) const {
  auto const& world = session_.world;
  bool const is_fluid = session_.role == Role::fluid;
  int const fluid_ranks = is_fluid ? world.size : world.partner_size;
  int const dem_ranks = is_fluid ? world.partner_size : world.size;
  double const wall_s = now_s() - session_.start_s + wall_before_s_;
  Json json;
  json["case"] = session_.scene.text("case.name", "");
  json["variant"] = session_.scene.text("run.variant", "");
  json["version"] = session_.scene.text("run.version", version());
  json["status"] = status;
  json["wall_s"] = wall_s;
  json["core_s"] = wall_s * (fluid_ranks + dem_ranks);
  json["windows"] = windows_;
  json["restarts"] = restarts_;
  json["particles"] = dem_.particles;
  json["cells"] = cells_;
  json["ranks"] = {{"fluid", fluid_ranks}, {"dem", dem_ranks}};
  json["scheme"] = session_.scene.text("coupling.scheme", "serial");
  json["bytes_per_particle"] = world.has_partner()
                                   ? 8 * (doubles_per_particle(agreed_.layout.to_fluid) +
                                          doubles_per_particle(agreed_.layout.to_dem))
                                   : 0;
  if (agreed_.models.porosity()) {
    json["smoothing_length_m"] = agreed_.models.smoothing_length_m;
  }
  json["timings"] = Json::object();
  json["processor_timings"] = Json::object();
  if (fluid_ranks > 0) {
    json["timings"]["fluid"] = timings(fluid_.seconds, fluid_ranks);
    json["processor_timings"]["fluid"] = timings(fluid_.processor_seconds, fluid_ranks);
  }
  if (dem_ranks > 0) {
    json["timings"]["dem"] = timings(dem_.seconds, dem_ranks);
    json["processor_timings"]["dem"] = timings(dem_.processor_seconds, dem_ranks);
  }
  json["budgets"] = Json::object();
  for (auto const& [name, value] : budgets_) {
    json["budgets"][name] = number(value);
  }
  json["extremes"] = Json::object();
  for (auto const& [name, value] : extremes_) {
    json["extremes"][name] = number(value);
  }
  json["active"] = Json::array();
  json["left_out"] = Json::array();
  for (Feature const& feature : agreed_.features) {
    json[feature.active ? "active" : "left_out"].push_back(
        {{"name", feature.name}, {"reason", feature.reason}});
  }
  json["quantities"] = Json::array();
  for (Quantity const& column : last_) {
    json["quantities"].push_back(
        {{"name", column.name}, {"value", number(column.value)}, {"unit", unit_of(column.name)}});
  }
  std::ofstream file(session_.scene.directory() / "summary.json");
  file << json.dump(2) << "\n";
  if (!file.flush()) {
    throw std::runtime_error("cannot write summary.json in " + session_.scene.directory().string());
  }
}

}  // namespace slidewave
