// A column of numbers kept with each atom by LIGGGHTS: through migration, sorting and restarts.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class FixPropertyAtom;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace slidewave::dem {

/// Adds column slidewave_`name` with one value per entry of `initial`. One entry: read and write
/// ->vector_atom[i], more: ->array_atom[i]. Values written before the first run are kept.
LAMMPS_NS::FixPropertyAtom* add_atom_column(LAMMPS_NS::LAMMPS& lmp, std::string const& name,
                                            std::vector<double> const& initial);

}  // namespace slidewave::dem
