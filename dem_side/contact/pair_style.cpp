#include "pair_style.h"

#include <algorithm>
#include <cstdio>

// clang-format off
#include "fix_insert_stream.h"
#include "pair_gran.h"
// clang-format on
#include "atom.h"
#include "comm.h"
#include "contact_scale.h"
#include "domain.h"
#include "error.h"
#include "fix_contact_memory.h"
#include "lammps.h"
#include "law_settings.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace slidewave::dem {
namespace {

char fix_id[] = "slidewave_contacts";

}  // namespace

OwnPairs* OwnPairs::current_ = nullptr;

OwnPairs::OwnPairs(LAMMPS_NS::LAMMPS& lmp, NamedLaw named) : lmp_(lmp), named_(named) {
  current_ = this;
}

OwnPairs::~OwnPairs() {
  if (fix_) {
    lmp_.modify->delete_fix(fix_id);
  }
  if (current_ == this) {
    current_ = nullptr;
  }
}

void OwnPairs::settings(int argument_count, char** arguments) {
  check_words(*lmp_.error, argument_count, arguments);
  Settings settings(&lmp_);
  read_linear(settings, law_.normal);
  if (named_.coulomb) {
    read_coulomb(settings, law_.slider);
  }
  if (named_.jiang) {
    read_jiang(settings, law_.jiang, twist_);
  }
  if (named_.iwashita_oda) {
    read_iwashita_oda(settings, law_.iwashita_oda);
  }
  if (!settings.parseArguments(argument_count, arguments)) {
    lmp_.error->all(FLERR, settings.error_message.c_str());
  }
  scale_stiffness(law_.normal.kn);
  scale_stiffness(law_.slider.ks);
  scale_rotation(law_.iwashita_oda.kr);
  choose_kernel();
}

void OwnPairs::init() {
  check(*lmp_.error, law_.normal);
  if (named_.coulomb) {
    check(*lmp_.error, law_.slider);
  }
  if (named_.jiang) {
    check(*lmp_.error, law_.jiang);
  }
  if (named_.iwashita_oda) {
    check(*lmp_.error, law_.iwashita_oda);
  }
  check_scene();
  keep_history();
}

void OwnPairs::check_scene() const {
  if (lmp_.domain->triclinic) {
    lmp_.error->all(FLERR, "model linear needs a box with right angles");
  }
  double largest_m = 0;
  for (int i = 0; i < lmp_.atom->nlocal; ++i) {
    largest_m = std::max(largest_m, 2 * lmp_.atom->radius[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, &largest_m, 1, MPI_DOUBLE, MPI_MAX, lmp_.world);
  if (largest_m == 0) {
    lmp_.atom->sortfreq = 0;  // LIGGGHTS cannot sort nothing
  }
  for (int axis = 0; axis < 3; ++axis) {
    double const width_m = lmp_.domain->prd[axis];
    if (lmp_.domain->periodicity[axis] && width_m <= largest_m) {
      std::string const text = "the box is periodic and " + std::to_string(width_m) +
                               " m wide along " + "xyz"[axis] + ", but a particle of " +
                               std::to_string(largest_m) +
                               " m would touch its own image: make it wider than that";
      lmp_.error->all(FLERR, text.c_str());
    }
  }
}

// An own contact with a partner of another rank is computed on both: newton must be off.
void OwnPairs::keep_history() {
  if (!fix_) {
    std::string numbers = std::to_string(4 * pairs_.registers());
    char group[] = "all";
    char style[] = "slidewave/contacts";
    char* arguments[] = {fix_id, group, style, numbers.data()};
    lmp_.modify->add_fix(4, arguments);
    fix_ = static_cast<LAMMPS_NS::FixContactMemory*>(lmp_.modify->find_fix_id(fix_id));
    if (lmp_.comm->me == 0 && lmp_.screen) {
      std::fprintf(lmp_.screen, "contact kernel: %s, %zu numbers of history a contact\n",
                   name_.c_str(), numbers_);
    }
  }
  fix_->attach(&pairs_);
}

// The loop with the machine's widest registers: compiled twice, the same results.
template <class Kernel>
struct Loop {
  template <class Tally>
  static void plain(PairLaw const& law, PairList& pairs, double dt_s, bool advance,
                    Dissipated& lost, Tally const& tally) {
    Kernel::run(law, pairs, dt_s, advance, lost, tally);
  }
#if defined(__x86_64__)
  template <class Tally>
  __attribute__((target("avx2"))) static void wide(PairLaw const& law, PairList& pairs, double dt_s,
                                                   bool advance, Dissipated& lost,
                                                   Tally const& tally) {
    Kernel::run(law, pairs, dt_s, advance, lost, tally);
  }
#endif
  template <class Tally>
  static void run(PairLaw const& law, PairList& pairs, double dt_s, bool advance, Dissipated& lost,
                  Tally const& tally) {
#if defined(__x86_64__)
    static bool const has_avx2 = __builtin_cpu_supports("avx2");
    if (has_avx2) {
      wide(law, pairs, dt_s, advance, lost, tally);
      return;
    }
#endif
    plain(law, pairs, dt_s, advance, lost, tally);
  }
};

// What a contact adds to LIGGGHTS' pressure.
struct Tally {
  LAMMPS_NS::PairGran& pair;
  PairList const& pairs;
  int locals;
  void operator()(std::size_t i, std::int32_t body, Vec4 const& f, Vec4 const& d) const {
    pair.ev_tally_xyz(static_cast<int>(i), pairs.atom_of(body), locals, 0, 0.0, 0.0, f[0], f[1],
                      f[2], d[0], d[1], d[2]);
  }
};

struct NoTally {
  SLIDEWAVE_INLINE void operator()(std::size_t, std::int32_t, Vec4 const&, Vec4 const&) const {}
};

template <bool friction, Rolling rolling, bool damped>
void OwnPairs::use_kernel() {
  using Kernel = PairKernel<friction, rolling, damped>;
  // The angle of twist and the normal both turn when the partners change places.
  pairs_.set_history(std::vector<Slot>(Kernel::registers, Slot{Vec4{-1, -1, -1, 1}}));
  numbers_ = Kernel::numbers;
  elastic_ = &Kernel::elastic;
  run_ = [](OwnPairs& self, LAMMPS_NS::PairGran& pair, double dt_s, bool advance) {
    if (pair.evflag) {
      Tally const tally{pair, self.pairs_, self.lmp_.atom->nlocal};
      Loop<Kernel>::plain(self.law_, self.pairs_, dt_s, advance, self.lost_, tally);
    } else {
      Loop<Kernel>::run(self.law_, self.pairs_, dt_s, advance, self.lost_, NoTally{});
    }
  };
}

template <bool friction, Rolling rolling>
void OwnPairs::use_damping() {
  bool const damped = law_.normal.zeta > 0 || (friction && law_.slider.zeta > 0);
  name_ += damped ? " + damping" : "";
  damped ? use_kernel<friction, rolling, true>() : use_kernel<friction, rolling, false>();
}

template <bool friction>
void OwnPairs::use_rolling() {
  if (named_.jiang && law_.jiang.shape > 0) {
    name_ += twist_ ? " + jiang with twist" : " + jiang";
    twist_ ? use_damping<friction, Rolling::jiang_twist>()
           : use_damping<friction, Rolling::jiang>();
  } else if (named_.iwashita_oda && law_.iwashita_oda.kr > 0) {
    name_ += " + iwashita_oda";
    use_damping<friction, Rolling::iwashita_oda>();
  } else {
    use_damping<friction, Rolling::off>();
  }
}

void OwnPairs::choose_kernel() {
  bool const friction = named_.coulomb && law_.slider.mu > 0;
  name_ = friction ? "linear + coulomb" : "linear";
  friction ? use_rolling<true>() : use_rolling<false>();
}

void OwnPairs::refuse_unsupported(LAMMPS_NS::PairGran& pair) const {
  if (pair.cpl() || pair.storeContactForces() || pair.storeContactForcesStress() ||
      pair.storeSumDelta() || pair.store_sum_normal_force() || pair.fr_pair() ||
      lmp_.modify->n_fixes_style("relax") > 0) {
    lmp_.error->all(FLERR,
                    "model linear serves no compute or fix that reads single contacts (pair/gran/"
                    "local, contact forces, stress by contacts, rigid, relax): take model "
                    "hooke/stiffness for that");
  }
}

void OwnPairs::rebuild(LAMMPS_NS::PairGran& pair) {
  refuse_unsupported(pair);
  fix_->collect();
  pairs_.rebuild(*lmp_.atom, *lmp_.domain, *pair.list, fix_->memory(), pair.freeze_group_bit());
}

void OwnPairs::compute(LAMMPS_NS::PairGran& pair, int eflag, int vflag) {
  if (eflag || vflag) {
    pair.ev_setup(eflag, vflag);
  } else {
    pair.evflag = pair.vflag_fdotr = 0;
  }
  if (!pairs_.valid() || lmp_.neighbor->ago == 0) {
    rebuild(pair);
  } else {
    pairs_.take(*lmp_.atom);
  }
  wall_books().now = {};
  run_(*this, pair, lmp_.update->dt, pair.computeflag() && pair.shearupdate());
  if (pair.computeflag()) {
    pairs_.give(*lmp_.atom);
  }
}

}  // namespace slidewave::dem
