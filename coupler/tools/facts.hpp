// The measured numbers of a scene that the pre-flight check works from: one flat JSON object, SI
// units in the names. All are optional: a check whose numbers are missing is left out and says so.
//
//   window_s end_time_s gravity_m_s2 two_way regime scheme  case.toml has these too; facts win
//   dem_dt_s coarse_grain smoothing_length_m
//   drag drag_coefficient formulation                     names of coupler/physics/drag_models.hpp
//   virtual_mass                                          none, constant, zuber
//   particles diameter_min_m diameter_max_m               number of particles, their sizes
//   particle_density_min_kg_m3                            lightest material
//   stiffness_N_m tangential_stiffness_N_m                kn, ks (default 0.9 kn)
//   contact_law contact_scaling                           "own" or "packaged"; clump.hpp, of the
//   above contact_number                                        of the smallest particle (default
//   5) column_height_m                                       highest column of particles
//   solid_fraction                                        of the densest part (default 0.6, or what
//                                                         few particles make of their kernel)
//   periodic_width_m                                      narrowest periodic direction
//   speed_m_s                                             fastest particle or fluid expected
//   held                                                  no particle is free to move
//   slip_m_s                                              largest |u_f - v| (default speed_m_s)
//   fluid_density_kg_m3 fluid_viscosity_Pa_s              the denser fluid
//   second_density_kg_m3 second_viscosity_Pa_s            of the fluid above a free surface
//   surface_tension_N_m
//   fluid_dt_s                                            fixed fluid step; absent where adaptive
//   cells cell_size_m smallest_cell_m
//   ranks memory_available_bytes particle_steps_per_s cell_steps_per_s
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "slidewave/scene.hpp"

namespace slidewave::preflight {

class Facts {
 public:
  explicit Facts(nlohmann::json values) : values_(std::move(values)) {}

  bool has(std::string const& name) const { return values_.contains(name); }
  /// Throws InputError where the fact is absent or no number.
  double number(std::string const& name) const;
  double number(std::string const& name, double otherwise) const;
  std::string text(std::string const& name, std::string const& otherwise) const;
  bool flag(std::string const& name, bool otherwise) const;
  void add_missing(std::string const& name, nlohmann::json const& value);
  std::vector<std::string> names() const;

 private:
  nlohmann::json values_;
};

/// Every name of the list above.
std::vector<std::string> const& known_facts();

/// Adds to the facts what the case itself says.
void add_case(Scene const& scene, Facts& facts);

}  // namespace slidewave::preflight
