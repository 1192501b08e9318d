// Copies of what the atoms of this rank are and do.
#pragma once

#include "slidewave/table.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::dem {

/// Whether any direction of the box is periodic: atoms may then stand outside it.
bool is_periodic(LAMMPS_NS::LAMMPS& lmp);
/// Positions [m], in the box.
void gather_positions(LAMMPS_NS::LAMMPS& lmp, Table::Column position_m);
/// Resizes the table and fills, of id, position, velocity, angular_velocity, radius and mass,
/// the columns that it has.
void gather_atoms(LAMMPS_NS::LAMMPS& lmp, Table& particles);

}  // namespace slidewave::dem
