#include "atoms_gather.h"

#include "atom.h"
#include "domain.h"
#include "lammps.h"
#include "stock_facts.h"

namespace slidewave::dem {

bool is_periodic(LAMMPS_NS::LAMMPS& lmp) {
  int const* const periodic = lmp.domain->periodicity;
  return periodic[0] || periodic[1] || periodic[2];
}

void gather_positions(LAMMPS_NS::LAMMPS& lmp, Table::Column position_m) {
  for (int i = 0; i < lmp.atom->nlocal; ++i) {
    position_m.col(i) = wrapped(lmp, lmp.atom->x[i]);
  }
}

void gather_atoms(LAMMPS_NS::LAMMPS& lmp, Table& particles) {
  LAMMPS_NS::Atom const& atom = *lmp.atom;
  particles.resize(atom.nlocal);
  auto const fill = [&](char const* name, auto const& value) {
    if (particles.has(name)) {
      Table::Column column = particles[name];
      for (int i = 0; i < atom.nlocal; ++i) {
        value(i, column.col(i));
      }
    }
  };
  fill("id", [&](int i, auto out) { out[0] = atom.tag[i]; });
  fill("position", [&](int i, auto out) { out = wrapped(lmp, atom.x[i]); });
  fill("velocity", [&](int i, auto out) { out = Vec3(atom.v[i]); });
  fill("angular_velocity", [&](int i, auto out) { out = Vec3(atom.omega[i]); });
  fill("radius", [&](int i, auto out) { out[0] = atom.radius[i]; });
  fill("mass", [&](int i, auto out) { out[0] = atom.rmass[i]; });
}

}  // namespace slidewave::dem
