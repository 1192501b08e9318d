#include "models.hpp"

#include <fmt/format.h>

#include <utility>

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

void refuse_if(bool wrong, Scene const& scene, std::string const& key, std::string const& value,
               std::string const& remedy) {
  if (wrong) {
    throw InputError((scene.directory() / "case.toml").string(), key, "\"" + value + "\"", remedy);
  }
}

}  // namespace

Models Models::from(Scene const& scene) {
  Models models;
  models.concurrent =
      choice(scene, "coupling.scheme", "serial", {"serial", "concurrent", "auto"}) == "concurrent";
  std::string const formulation = choice(scene, "models.formulation", "A", {"A", "B"});
  std::vector<std::string> laws = drag_law_names();
  laws.emplace_back("none");
  std::string const law = choice(scene, "models.drag", "di_felice", laws);
  std::string const coefficient =
      choice(scene, "models.drag_coefficient", "brown_lawler", drag_coefficient_names());
  models.drag = law != "none";
  if (models.drag) {
    models.drag_model = slidewave::drag_model(law, coefficient, formulation);
  }
  models.formulation = formulation == "B" ? Formulation::B : Formulation::A;
  models.pressure_gradient = scene.flag("models.pressure_gradient", !models.archimedes());
  models.viscous_force = scene.flag("models.viscous_force", false);
  models.lift = choice(scene, "models.lift", "none", {"none", "saffman_mei"}) != "none";
  models.torque = choice(scene, "models.torque", "none", {"none", "rotational_drag"}) != "none";
  std::string const added =
      choice(scene, "models.virtual_mass", "none", {"none", "constant", "zuber"});
  models.virtual_mass = added == "constant" ? VirtualMass::constant
                        : added == "zuber"  ? VirtualMass::zuber
                                            : VirtualMass::none;
  models.two_way =
      choice(scene, "coupling.reaction", "two_way", {"two_way", "one_way"}) == "two_way";
  std::string const regime = choice(scene, "coupling.regime", "auto", {"auto", "mild", "stiff"});
  models.stiff = regime == "stiff" && models.ledger();
  if (models.archimedes()) {
    for (auto const& [key, on] : {std::pair("models.pressure_gradient", models.pressure_gradient),
                                  std::pair("models.viscous_force", models.viscous_force)}) {
      refuse_if(on, scene, key, "true",
                "belongs to models.formulation = \"A\": in B drag holds it, and Archimedes' force "
                "is buoyancy");
    }
  }
  if (models.stiff) {
    std::string const mild =
        "goes with coupling.regime = \"mild\" only; shorten coupling.window, or leave it out";
    refuse_if(models.archimedes(), scene, "models.formulation", "B", mild);
    refuse_if(models.moves_fluid_along(), scene, "models.virtual_mass", added, mild);
    refuse_if(models.lift, scene, "models.lift", "saffman_mei", mild);
  }
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
  if (models.concurrent) {
    std::string const serial = "goes with coupling.scheme = \"serial\" only";
    refuse_if(models.archimedes() && models.two_way, scene, "models.formulation", "B", serial);
    refuse_if(models.moves_fluid_along(), scene, "models.virtual_mass", added, serial);
    refuse_if(models.viscous_force, scene, "models.viscous_force", "true", serial);
    refuse_if(models.lift, scene, "models.lift", "saffman_mei", serial);
    refuse_if(models.torque, scene, "models.torque", "rotational_drag", serial);
  }
  std::string const outside =
      choice(scene, "coupling.outside", "error", {"error", "warn", "ignore"});
  models.outside = outside == "error"  ? Outside::error
                   : outside == "warn" ? Outside::warn
                                       : Outside::ignore;
  models.coarse_grain =
      positive(scene, "parameters.coarse_grain", scene.number("parameters.coarse_grain", 1.0));
  if (scene.has("models.coarse_grain_by_type")) {
    models.coarse_grain_by_type = scene.numbers("models.coarse_grain_by_type");
    for (double const alpha : models.coarse_grain_by_type) {
      positive(scene, "models.coarse_grain_by_type", alpha);
    }
    refuse_if(models.coarse_grain != 1, scene, "parameters.coarse_grain",
              fmt::format("{:g}", models.coarse_grain),
              "leave it at 1 beside models.coarse_grain_by_type");
    std::string const scaling = scene.text("models.contact_scaling", "none");
    refuse_if(scaling != "none", scene, "models.contact_scaling", scaling,
              "goes with one alpha for all: a contact of two types has no alpha of its own");
  }
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
  auto const want = [&](bool on, Field const& field, char const* model, char const* key) {
    if (on) {
      needs.push_back({field, model, key});
    }
  };
  bool const slip = drag || lift;
  bool const added = moves_fluid_along();
  char const* const pushed = drag    ? "drag"
                             : lift  ? "lift"
                             : added ? "virtual mass"
                                     : "Archimedes' force";
  char const* const pusher = drag    ? "models.drag"
                             : lift  ? "models.lift"
                             : added ? "models.virtual_mass"
                                     : "models.formulation";
  want(slip, {"velocity", "m/s", 3}, pushed, pusher);
  want(slip || torque, {"viscosity", "Pa s", 1}, slip ? pushed : "torque",
       slip ? pusher : "models.torque");
  want(slip || added || archimedes(), {"density", "kg/m3", 1}, pushed, pusher);
  want(porosity() && (drag || virtual_mass == VirtualMass::zuber), {"void_fraction", "-", 1},
       pushed, pusher);
  want(drag && ledger() && !concurrent, {"mean_velocity", "m/s", 3}, "two-way momentum",
       "coupling.reaction");
  want(stiff, {"drag_reaction", "Pa/m", 3}, "stiff regime", "coupling.regime");
  want(pressure_gradient, {"pressure_gradient", "Pa/m", 3}, "pressure-gradient force",
       "models.pressure_gradient");
  want(added, {"acceleration", "m/s2", 3}, "virtual mass", "models.virtual_mass");
  want(viscous_force, {"viscous_stress", "Pa/m", 3}, "viscous force", "models.viscous_force");
  want(lift || torque, {"vorticity", "1/s", 3}, lift ? "lift" : "torque",
       lift ? "models.lift" : "models.torque");
  return needs;
}

std::vector<Need> Models::particle_needs() const {
  std::vector<Need> needs;
  if (stiff) {
    needs = {{{"travel", "m", 3}, "stiff regime", "coupling.regime"},
             {{"other_force", "N", 3}, "stiff regime", "coupling.regime"},
             {{"stiffest", "N/m", 1}, "stiff regime", "coupling.regime"}};
  }
  if (by_type()) {
    needs.push_back({{"type", "-", 1}, "coarse graining by type", "models.coarse_grain_by_type"});
  }
  return needs;
}

std::vector<Need> Models::answer_needs() const {
  std::vector<Need> needs;
  if (moves_fluid_along()) {
    needs.push_back({{"added_mass", "kg", 1}, "virtual mass", "models.virtual_mass"});
  }
  if (exchanged_force()) {
    bool const added = moves_fluid_along();
    needs.push_back({{"exchanged_force", "N", 3},
                     added ? "virtual mass" : "lift",
                     added ? "models.virtual_mass" : "models.lift"});
  }
  if (torque) {
    needs.push_back({{"rotational_drag", "N m s", 1}, "torque", "models.torque"});
    needs.push_back({{"fluid_spin", "rad/s", 3}, "torque", "models.torque"});
  }
  return needs;
}

std::vector<Feature> Models::features() const {
  return {
      {"drag", drag,
       drag ? drag_model.law + " " + drag_model.coefficient + ", formulation " +
                  (archimedes() ? "B" : "A")
            : "models.drag = \"none\""},
      {"pressure-gradient force", pressure_gradient,
       pressure_gradient ? "buoyancy included"
       : archimedes()    ? "Archimedes' force in its place (models.formulation = \"B\")"
                         : "models.pressure_gradient = false"},
      {"viscous force", viscous_force,
       viscous_force ? "V div tau" : "models.viscous_force = false"},
      {"lift", lift, lift ? "Saffman and Mei" : "models.lift = \"none\""},
      {"virtual mass", moves_fluid_along(),
       virtual_mass == VirtualMass::none       ? "models.virtual_mass = \"none\""
       : virtual_mass == VirtualMass::constant ? "C = 1/2"
                                               : "C after Zuber"},
      {"porosity", porosity(),
       porosity() ? "the fluid sees the particles' volume" : "coupling.reaction = \"one_way\""},
      {"momentum reaction and ledger", ledger(),
       ledger()  ? (concurrent ? "drag of the window's start on both sides, remainder repaid"
                               : "implicit in the fluid, remainder repaid")
       : two_way ? "no drag"
                 : "coupling.reaction = \"one_way\""},
      {"concurrent", concurrent,
       concurrent ? "both sides advance at once" : "serial: the fluid goes first"},
      {"stiff regime", stiff,
       stiff      ? "grains foreseen as oscillators, drag taken out of the pressure"
       : ledger() ? "coupling.regime is mild"
                  : "no reaction: the kick is exact"},
      {"coarse graining", coarse_grain != 1 || by_type(),
       by_type() ? fmt::format("alpha = {} by type", fmt::join(coarse_grain_by_type, ", "))
       : coarse_grain != 1 ? fmt::format("alpha = {}", coarse_grain)
                           : "a particle is a grain"},
      {"angular velocity", torque,
       torque ? "turned by the fluid, rotational drag" : "models.torque = \"none\""},
  };
}

}  // namespace slidewave
