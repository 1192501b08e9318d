#include "facts.hpp"

namespace slidewave::preflight {

double Facts::number(std::string const& name) const {
  auto const found = values_.find(name);
  if (found == values_.end() || !found->is_number()) {
    throw InputError("facts", name, found == values_.end() ? "" : found->dump(), "is not a number");
  }
  return found->get<double>();
}

double Facts::number(std::string const& name, double otherwise) const {
  return has(name) ? number(name) : otherwise;
}

std::string Facts::text(std::string const& name, std::string const& otherwise) const {
  if (!has(name)) {
    return otherwise;
  }
  if (!values_.at(name).is_string()) {
    throw InputError("facts", name, values_.at(name).dump(), "is not a text");
  }
  return values_.at(name).get<std::string>();
}

bool Facts::flag(std::string const& name, bool otherwise) const {
  if (!has(name)) {
    return otherwise;
  }
  if (!values_.at(name).is_boolean()) {
    throw InputError("facts", name, values_.at(name).dump(), "is neither true nor false");
  }
  return values_.at(name).get<bool>();
}

void Facts::add_missing(std::string const& name, nlohmann::json const& value) {
  if (!has(name)) {
    values_[name] = value;
  }
}

std::vector<std::string> Facts::names() const {
  std::vector<std::string> names;
  for (auto const& [name, value] : values_.items()) {
    names.push_back(name);
  }
  return names;
}

std::vector<std::string> const& known_facts() {
  static std::vector<std::string> const names{"window_s",
                                              "end_time_s",
                                              "gravity_m_s2",
                                              "two_way",
                                              "regime",
                                              "scheme",
                                              "dem_dt_s",
                                              "coarse_grain",
                                              "smoothing_length_m",
                                              "drag",
                                              "drag_coefficient",
                                              "formulation",
                                              "virtual_mass",
                                              "particles",
                                              "diameter_min_m",
                                              "diameter_max_m",
                                              "particle_density_min_kg_m3",
                                              "stiffness_N_m",
                                              "tangential_stiffness_N_m",
                                              "contact_law",
                                              "contact_scaling",
                                              "contact_number",
                                              "column_height_m",
                                              "solid_fraction",
                                              "periodic_width_m",
                                              "speed_m_s",
                                              "held",
                                              "slip_m_s",
                                              "fluid_density_kg_m3",
                                              "fluid_viscosity_Pa_s",
                                              "second_density_kg_m3",
                                              "second_viscosity_Pa_s",
                                              "surface_tension_N_m",
                                              "fluid_dt_s",
                                              "cells",
                                              "cell_size_m",
                                              "smallest_cell_m",
                                              "ranks",
                                              "memory_available_bytes",
                                              "particle_steps_per_s",
                                              "cell_steps_per_s"};
  return names;
}

void add_case(Scene const& scene, Facts& facts) {
  struct Number {
    char const* fact;
    char const* key;
  };
  for (Number const& number :
       {Number{"window_s", "coupling.window"}, Number{"end_time_s", "case.end_time"},
        Number{"dem_dt_s", "parameters.dem_dt"}, Number{"coarse_grain", "parameters.coarse_grain"},
        Number{"smoothing_length_m", "coupling.smoothing_length"}}) {
    if (scene.has(number.key)) {
      facts.add_missing(number.fact, scene.number(number.key));
    }
  }
  if (scene.has("physics.gravity")) {
    facts.add_missing("gravity_m_s2", scene.vector("physics.gravity").norm());
  }
  facts.add_missing("two_way", scene.text("coupling.reaction", "two_way") == "two_way");
  facts.add_missing("regime", scene.text("coupling.regime", "mild"));
  facts.add_missing("scheme", scene.text("coupling.scheme", "serial"));
  facts.add_missing("drag", scene.text("models.drag", "di_felice"));
  facts.add_missing("drag_coefficient", scene.text("models.drag_coefficient", "brown_lawler"));
  facts.add_missing("formulation", scene.text("models.formulation", "A"));
  facts.add_missing("virtual_mass", scene.text("models.virtual_mass", "none"));
  facts.add_missing("contact_scaling", scene.text("models.contact_scaling", "none"));
}

}  // namespace slidewave::preflight
