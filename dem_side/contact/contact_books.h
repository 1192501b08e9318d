// Energy that contacts hold and lose, for the audit (energy_audit.h). SI units.
#pragma once

namespace slidewave::dem {

/// Energy [J] turned into heat, of this rank's share (half where the partner is another rank's). A
/// spring that is still strained when its contact opens counts as friction or rolling.
struct Dissipated {
  double friction = 0;
  double damping = 0;
  double rolling = 0;
};

/// Energy [J] kept in the springs.
struct Elastic {
  double normal = 0;
  double tangential = 0;
  double rolling = 0;
};

/// What this rank's contacts with walls add up. `now` is of the last force evaluation, the others
/// count from the start of the process.
struct WallBooks {
  Elastic now;
  Elastic stored;      ///< work done on the springs
  double damping = 0;  ///< lost in dashpots
  double work = 0;     ///< of moving walls on particles
};

/// One a process: every wall books here.
inline WallBooks& wall_books() {
  static WallBooks books;
  return books;
}

}  // namespace slidewave::dem
