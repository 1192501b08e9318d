// fix ID all slidewave/contacts N: carries what contacts remember (contact_memory.h, N numbers a
// contact) with the atoms. Made by the pair style; not for scripts.
//
// In a restart file an atom has: size of what follows and itself, number of contacts, their
// records.
#pragma once

#include "contact_memory.h"
#include "fix.h"

namespace slidewave::dem {
class PairList;
}

namespace LAMMPS_NS {

class FixContactMemory : public Fix {
 public:
  FixContactMemory(LAMMPS* lmp, int argument_count, char** arguments);
  ~FixContactMemory() override;
  int setmask() override;
  void setup_pre_exchange() override { pre_exchange(); }
  void pre_exchange() override;

  void grow_arrays(int most) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int atom) override;
  int pack_exchange(int atom, double* buffer) override;
  int unpack_exchange(int atom, double* buffer) override;
  int pack_restart(int atom, double* buffer) override;
  void unpack_restart(int atom, int nth) override;
  int size_restart(int atom) override;
  int maxsize_restart() override;
  double memory_usage() override { return 0; }

  /// The list that holds the history between rebuilds; null: none yet.
  void attach(slidewave::dem::PairList* pairs) { pairs_ = pairs; }
  slidewave::dem::ContactMemory& memory() { return memory_; }
  /// Brings the records up to date with the list; the list stays as it is.
  void collect();

 private:
  void bring_up_to_date();

  slidewave::dem::ContactMemory memory_;
  slidewave::dem::PairList* pairs_ = nullptr;
};

}  // namespace LAMMPS_NS
