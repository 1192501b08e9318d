// The checks, by what they are about. Each adds its rows to the sheet; limits and their sources are
// in coupler/physics/limits.
#pragma once

#include "facts.hpp"
#include "sheet.hpp"
#include "slidewave/physics/clump.hpp"

namespace slidewave::preflight {

void check_particles(Facts const& facts, Sheet& sheet);
void check_coupling(Facts const& facts, Sheet& sheet);
void check_fluid(Facts const& facts, Sheet& sheet);
void check_cost(Facts const& facts, Sheet& sheet);
/// Facts whose name nobody knows, with the nearest known one.
void check_names(Facts const& facts, Sheet& sheet);

/// Volume of a sphere [m3].
double sphere_volume(double diameter_m);
/// Factors from the contact constants of the case to those of a particle: 1 unless it scales them.
ContactScale contact_scale(Facts const& facts);
/// Share of space that the particles take where they are densest, and where it comes from.
double solid_fraction(Facts const& facts);

}  // namespace slidewave::preflight
