#include "atoms_state.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "atom.h"
#include "atom_column.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "fix_contact_history.h"
#include "fix_contact_memory.h"
#include "fix_property_atom.h"
#include "fix_slidewave.h"
#include "integrate.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

using LAMMPS_NS::Atom;
using LAMMPS_NS::FixContactHistory;
using LAMMPS_NS::FixContactMemory;
using LAMMPS_NS::FixPropertyAtom;
using LAMMPS_NS::FixSlidewave;
using LAMMPS_NS::LAMMPS;

namespace slidewave::dem {
namespace {

/// What a checkpoint's records consist of: all fixes that keep values with atoms, in order.
std::vector<std::string> record_layout(LAMMPS& lmp) {
  std::vector<std::string> names = {lmp.atom->atom_style};
  for (int k = 0; k < lmp.atom->nextra_grow; ++k) {
    LAMMPS_NS::Fix const& fix = *lmp.modify->fix[lmp.atom->extra_grow[k]];
    names.push_back(std::string(fix.id) + " (" + fix.style + ")");
  }
  return names;
}

std::string joined(std::vector<std::string> const& names) {
  std::string text;
  for (std::string const& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

/// Made with the first checkpoint; it stays, since taking a fix away needs another set-up.
FixPropertyAtom* forces_column(LAMMPS& lmp) {
  auto* const found =
      static_cast<FixPropertyAtom*>(lmp.modify->find_fix_id("slidewave_kept_force"));
  return found ? found : add_atom_column(lmp, "kept_force", std::vector<double>(6, 0.0));
}

/// Before each half kick the kick keeps the force without the fluid's; else it is atom->f.
void keep_forces(LAMMPS& lmp, FixPropertyAtom& kept, FixSlidewave const* kick) {
  Atom const& atom = *lmp.atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    double const* const force = kick ? kick->other_force_N(i) : atom.f[i];
    double const* const torque =
        kick && kick->has("rotational_drag") ? kick->other_torque_N_m(i) : atom.torque[i];
    std::copy_n(force, 3, kept.array_atom[i]);
    std::copy_n(torque, 3, kept.array_atom[i] + 3);
  }
}

void put_forces_back(LAMMPS& lmp, FixPropertyAtom const& kept, FixSlidewave* kick) {
  Atom const& atom = *lmp.atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    std::copy_n(kept.array_atom[i], 3, atom.f[i]);
    std::copy_n(kept.array_atom[i] + 3, 3, atom.torque[i]);
  }
  if (kick) {
    kick->keep_forces();
  }
}

/// Contact histories go from neighbour lists to the atoms, and the lists are out of date.
void take_histories(LAMMPS& lmp) {
  for (int k = 0; k < lmp.modify->nfix; ++k) {
    LAMMPS_NS::Fix* const fix = lmp.modify->fix[k];
    if (dynamic_cast<FixContactHistory*>(fix) || dynamic_cast<FixContactMemory*>(fix)) {
      fix->setup_pre_exchange();
    }
  }
}

std::vector<double> records(LAMMPS& lmp) {
  // As large as LIGGGHTS' own buffer for one atom, several times over.
  std::vector<double> one(65536 + 16 * static_cast<std::size_t>(lmp.comm->maxexchange_fix));
  std::vector<double> all;
  for (int i = 0; i < lmp.atom->nlocal; ++i) {
    int const count = lmp.atom->avec->pack_exchange(i, one.data());
    all.insert(all.end(), one.begin(), one.begin() + count);
  }
  return all;
}

/// Whether a position is this rank's; those beyond the outer faces belong to the ranks there.
bool is_mine(LAMMPS& lmp, double const* position_m) {
  LAMMPS_NS::Domain& domain = *lmp.domain;
  double x[3] = {position_m[0], position_m[1], position_m[2]};
  domain.remap(x);
  for (int d = 0; d < 3; ++d) {
    bool const first = lmp.comm->myloc[d] == 0;
    bool const last = lmp.comm->myloc[d] == lmp.comm->procgrid[d] - 1;
    if ((x[d] < domain.sublo[d] && !first) || (x[d] >= domain.subhi[d] && !last)) {
      return false;
    }
  }
  return true;
}

void drop_all(LAMMPS& lmp) {
  Atom& atom = *lmp.atom;
  if (atom.map_style) {
    atom.map_clear();
  }
  atom.nlocal = atom.nghost = 0;
}

/// Adds the atoms of records, all of them or this rank's. A record begins with its length and the
/// position (LIGGGHTS' exchange relies on that too).
void add(LAMMPS& lmp, std::vector<double> values, bool only_mine) {
  for (std::size_t at = 0; at < values.size();) {
    double* const record = values.data() + at;
    if (!only_mine || is_mine(lmp, record + 1)) {
      lmp.atom->avec->unpack_exchange(record);
    }
    at += static_cast<std::size_t>(record[0]);
  }
}

long count_all(LAMMPS& lmp) {
  long count = lmp.atom->nlocal;
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_LONG, MPI_SUM, lmp.world);
  return count;
}

void set_up_again(LAMMPS& lmp) {
  Atom& atom = *lmp.atom;
  if (atom.map_style) {
    atom.map_init();
    atom.map_set();
  }
  lmp.init();
  lmp.update->integrate->setup();
}

}  // namespace

std::string fix_without_checkpoint(LAMMPS& lmp) {
  for (int k = 0; k < lmp.modify->nfix; ++k) {
    std::string style = lmp.modify->fix[k]->style;
    for (char const* stateful : {"insert/", "move/mesh", "multisphere", "rigid", "deform", "ave/",
                                 "mesh/surface/stress/servo", "massflow/mesh", "continuum"}) {
      if (style.rfind(stateful, 0) == 0) {
        return style;
      }
    }
  }
  return "";
}

void pass_atoms(LAMMPS& lmp, State& state, FixSlidewave* kick) {
  FixPropertyAtom* const kept = forces_column(lmp);
  std::vector<std::string> layout = record_layout(lmp);
  std::vector<std::string> const mine = layout;
  state.pass("atoms.layout", layout);
  if (layout != mine) {
    throw std::runtime_error("the particles of the checkpoint carry [" + joined(layout) +
                             "], those of this scene [" + joined(mine) +
                             "]: the script or the models have changed; undo the change or run "
                             "without --restart");
  }
  take_histories(lmp);  // loading: those of the script's atoms, which must not come back
  std::vector<double> all;
  if (state.saving()) {
    keep_forces(lmp, *kept, kick);
    all = records(lmp);
  }
  long total = count_all(lmp);
  state.pass("atoms.total", total);
  drop_all(lmp);
  if (state.regrouped()) {
    for (int piece = 0; piece < state.pieces(); ++piece) {
      add(lmp, state.numbers("atoms.records", piece), true);
    }
  } else {
    state.pass("atoms.records", all);
    add(lmp, std::move(all), false);
  }
  lmp.atom->natoms = count_all(lmp);
  if (lmp.atom->natoms != total) {
    throw std::runtime_error("the checkpoint has " + std::to_string(total) + " particles, " +
                             std::to_string(lmp.atom->natoms) + " of them found a rank");
  }
  set_up_again(lmp);
  put_forces_back(lmp, *kept, kick);
}

}  // namespace slidewave::dem
