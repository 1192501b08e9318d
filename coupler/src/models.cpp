#include "models.hpp"

#include <fmt/format.h>

namespace slidewave {
namespace {

std::string choice(Scene const& scene, std::string const& key, std::string const& otherwise,
                   std::vector<std::string> const& allowed) {
  std::string value = scene.text(key, otherwise);
  std::string list;
  for (std::string const& option : allowed) {
    if (value == option) {
      return value;
    }
    list += (list.empty() ? "\"" : ", \"") + option + "\"";
  }
  throw InputError((scene.directory() / "case.toml").string(), key, "\"" + value + "\"",
                   "is unknown; choose one of " + list);
}

double positive(Scene const& scene, std::string const& key, double value) {
  if (!(value > 0)) {
    throw InputError((scene.directory() / "case.toml").string(), key, fmt::format("{}", value),
                     "must be positive");
  }
  return value;
}

}  // namespace

Models Models::from(Scene const& scene) {
  Models models;
  models.concurrent =
      choice(scene, "coupling.scheme", "serial", {"serial", "concurrent", "auto"}) == "concurrent";
  choice(scene, "models.formulation", "A", {"A"});
  std::vector<std::string> laws = drag_law_names();
  laws.emplace_back("none");
  std::string const law = choice(scene, "models.drag", "di_felice", laws);
  std::string const coefficient =
      choice(scene, "models.drag_coefficient", "brown_lawler", drag_coefficient_names());
  models.drag = law != "none";
  if (models.drag) {
    models.drag_model = slidewave::drag_model(law, coefficient, "A");
  }
  models.pressure_gradient = scene.flag("models.pressure_gradient", true);
  models.two_way =
      choice(scene, "coupling.reaction", "two_way", {"two_way", "one_way"}) == "two_way";
  std::string const regime = choice(scene, "coupling.regime", "auto", {"auto", "mild", "stiff"});
  models.stiff = regime == "stiff" && models.ledger();
  if (models.stiff && !models.pressure_gradient) {
    throw InputError((scene.directory() / "case.toml").string(), "coupling.regime", "\"stiff\"",
                     "needs models.pressure_gradient = true: drag reaches particles through it");
  }
  if (models.stiff && models.concurrent) {
    throw InputError((scene.directory() / "case.toml").string(), "coupling.scheme",
                     "\"concurrent\"",
                     "is for the mild regime: set coupling.regime = \"mild\" and a shorter window, "
                     "or coupling.scheme = \"serial\"");
  }
  std::string const outside =
      choice(scene, "coupling.outside", "error", {"error", "warn", "ignore"});
  models.outside = outside == "error"  ? Outside::error
                   : outside == "warn" ? Outside::warn
                                       : Outside::ignore;
  models.coarse_grain =
      positive(scene, "parameters.coarse_grain", scene.number("parameters.coarse_grain", 1.0));
  if (models.two_way) {
    models.smoothing_length_m =
        positive(scene, "coupling.smoothing_length", scene.number("coupling.smoothing_length"));
  }
  return models;
}

Models Models::none() {
  Models models;
  models.drag = models.pressure_gradient = models.two_way = false;
  return models;
}

std::vector<Need> Models::needs() const {
  std::vector<Need> needs;
  if (drag) {
    needs.push_back({{"velocity", "m/s", 3}, "drag"});
    needs.push_back({{"density", "kg/m3", 1}, "drag"});
    needs.push_back({{"viscosity", "Pa s", 1}, "drag"});
    if (porosity()) {
      needs.push_back({{"void_fraction", "-", 1}, "drag"});
    }
  }
  if (ledger() && !concurrent) {
    needs.push_back({{"mean_velocity", "m/s", 3}, "two-way momentum"});
  }
  if (stiff) {
    needs.push_back({{"drag_reaction", "Pa/m", 3}, "stiff regime"});
  }
  if (pressure_gradient) {
    needs.push_back({{"pressure_gradient", "Pa/m", 3}, "pressure-gradient force"});
  }
  return needs;
}

std::vector<Need> Models::particle_needs() const {
  if (!stiff) {
    return {};
  }
  return {{{"travel", "m", 3}, "stiff regime"},
          {{"other_force", "N", 3}, "stiff regime"},
          {{"stiffest", "N/m", 1}, "stiff regime"}};
}

std::vector<Feature> Models::features() const {
  return {
      {"drag", drag,
       drag ? drag_model.law + " " + drag_model.coefficient + ", formulation A"
            : "models.drag = \"none\""},
      {"pressure-gradient force", pressure_gradient,
       pressure_gradient ? "buoyancy included" : "models.pressure_gradient = false"},
      {"porosity", porosity(),
       porosity() ? "the fluid sees the particles' volume" : "coupling.reaction = \"one_way\""},
      {"momentum reaction and ledger", ledger(),
       ledger() ? (concurrent ? "drag of the window's start on both sides, remainder repaid"
                              : "drag implicit in the fluid, remainder repaid")
                : (drag ? "coupling.reaction = \"one_way\"" : "no drag")},
      {"concurrent", concurrent,
       concurrent ? "both sides advance at once" : "serial: the fluid goes first"},
      {"stiff regime", stiff,
       stiff      ? "grains foreseen as oscillators, drag taken out of the pressure"
       : ledger() ? "coupling.regime is mild"
                  : "no reaction: the kick is exact"},
      {"coarse graining", coarse_grain != 1,
       coarse_grain != 1 ? fmt::format("alpha = {}", coarse_grain) : "a particle is a grain"},
      {"angular velocity", false, "no model of lift or torque"},
  };
}

}  // namespace slidewave
