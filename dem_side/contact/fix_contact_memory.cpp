#include "fix_contact_memory.h"

#include <algorithm>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "pair_list.h"

namespace LAMMPS_NS {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

FixContactMemory::FixContactMemory(LAMMPS* lammps, int argument_count, char** arguments)
    : Fix(lammps, argument_count, arguments) {
  if (argument_count != 4) {
    error->fix_error(FLERR, this, "is made by the pair style");
  }
  restart_peratom = 1;
  create_attribute = 1;
  memory_.reset(index(force->inumeric(FLERR, arguments[3])));
  memory_.grow(index(atom->nmax));
  atom->add_callback(0);
  atom->add_callback(1);
}

FixContactMemory::~FixContactMemory() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

int FixContactMemory::setmask() {
  return FixConst::PRE_EXCHANGE;
}

void FixContactMemory::pre_exchange() {
  collect();
  if (pairs_) {
    pairs_->invalidate();
  }
}

void FixContactMemory::collect() {
  if (!pairs_ || !pairs_->valid()) {
    return;  // the records are up to date
  }
  grow_arrays(atom->nmax);
  pairs_->collect(*atom, memory_);
  std::size_t most = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    most = std::max(most, memory_.count(index(i)));
  }
  comm->maxexchange_fix =
      std::max(comm->maxexchange_fix, static_cast<int>(most * memory_.record() + 1));
}

void FixContactMemory::grow_arrays(int most) {
  memory_.grow(index(most));
}

void FixContactMemory::copy_arrays(int from, int to, int) {
  memory_.copy(index(from), index(to));
}

void FixContactMemory::set_arrays(int i) {
  memory_.grow(index(i) + 1);
  memory_.forget(index(i));
}

// Asked for outside a rebuild (a checkpoint): the list must not be taken for newer afterwards.
void FixContactMemory::bring_up_to_date() {
  if (pairs_ && pairs_->valid()) {
    pre_exchange();
  }
}

int FixContactMemory::pack_exchange(int i, double* buffer) {
  bring_up_to_date();
  std::size_t const count = memory_.count(index(i));
  buffer[0] = static_cast<double>(count);
  std::size_t const numbers = count * memory_.record();
  if (numbers > 0) {
    std::memcpy(buffer + 1, memory_.records(index(i)), numbers * sizeof(double));
  }
  return static_cast<int>(1 + numbers);
}

int FixContactMemory::unpack_exchange(int i, double* buffer) {
  if (pairs_) {
    pairs_->invalidate();  // what comes in is newer
  }
  auto const count = static_cast<std::size_t>(buffer[0]);
  memory_.adopt(index(i), buffer + 1, count);
  return static_cast<int>(1 + count * memory_.record());
}

int FixContactMemory::pack_restart(int i, double* buffer) {
  buffer[0] = size_restart(i);
  return 1 + pack_exchange(i, buffer + 1);
}

void FixContactMemory::unpack_restart(int i, int nth) {
  double* const extra = atom->extra[i];
  int start = 0;
  for (int n = 0; n < nth; ++n) {
    start += static_cast<int>(extra[start]);
  }
  unpack_exchange(i, extra + start + 1);
}

int FixContactMemory::size_restart(int i) {
  bring_up_to_date();
  return static_cast<int>(2 + memory_.count(index(i)) * memory_.record());
}

int FixContactMemory::maxsize_restart() {
  int most = 2;
  for (int i = 0; i < atom->nlocal; ++i) {
    most = std::max(most, size_restart(i));
  }
  return most;
}

}  // namespace LAMMPS_NS
