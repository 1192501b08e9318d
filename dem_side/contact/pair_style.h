// pair_style gran model linear ...: our contact laws for pairs of particles, behind LIGGGHTS'
// public interface of granular pair styles, with a loop and a history of our own (pair_kernel.h,
// pair_list.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contact_books.h"
#include "pair_kernel.h"
#include "pair_list.h"

namespace LAMMPS_NS {
class FixContactMemory;
class LAMMPS;
class PairGran;
}  // namespace LAMMPS_NS

namespace slidewave::dem {

/// Which law was named in the script; constants may still switch parts of it off.
struct NamedLaw {
  bool coulomb = false;
  bool jiang = false;
  bool iwashita_oda = false;
};

class OwnPairs {
 public:
  /// Works where it is called from a granular pair style only. `named`: models of the script.
  OwnPairs(LAMMPS_NS::LAMMPS& lmp, NamedLaw named);
  ~OwnPairs();
  OwnPairs(OwnPairs const&) = delete;

  /// Reads the constants of the script and chooses the kernel.
  void settings(int argument_count, char** arguments);
  /// Checks constants and scene. Collective.
  void init();
  void compute(LAMMPS_NS::PairGran& pair, int eflag, int vflag);

  /// Features of the kernel, e.g. "linear + coulomb".
  std::string name() const { return name_; }
  /// Numbers of history that each contact keeps.
  std::size_t numbers() const { return numbers_; }
  PairLaw const& law() const { return law_; }
  /// Contacts are known: forces have been worked out once.
  bool ready() const { return pairs_.valid(); }
  /// Of this rank, at the last force evaluation.
  Elastic elastic() const { return elastic_(law_, pairs_); }
  Dissipated const& dissipated() const { return lost_; }

  /// Heat so far of the pair style in use, for a checkpoint; null without one.
  static Dissipated* lost() { return current_ ? &current_->lost_ : nullptr; }

  /// The pair style in use, or null: the scene uses a packaged law.
  static OwnPairs const* current() { return current_; }

 private:
  void choose_kernel();
  void check_scene() const;
  void keep_history();
  void rebuild(LAMMPS_NS::PairGran& pair);
  void refuse_unsupported(LAMMPS_NS::PairGran& pair) const;

  using Run = void (*)(OwnPairs&, LAMMPS_NS::PairGran&, double dt_s, bool advance);
  using Sum = Elastic (*)(PairLaw const&, PairList const&);
  template <bool friction, Rolling rolling, bool damped>
  void use_kernel();
  template <bool friction, Rolling rolling>
  void use_damping();
  template <bool friction>
  void use_rolling();

  LAMMPS_NS::LAMMPS& lmp_;
  NamedLaw named_;
  bool twist_ = false;
  PairLaw law_;
  PairList pairs_;
  Dissipated lost_;
  std::string name_;
  std::size_t numbers_ = 0;
  Run run_ = nullptr;
  Sum elastic_ = nullptr;
  LAMMPS_NS::FixContactMemory* fix_ = nullptr;
  static OwnPairs* current_;
};

}  // namespace slidewave::dem
