// Pairs near enough to touch before the next rebuild of LIGGGHTS' neighbour list, laid out for the
// contact loop, with the history beside the pair.
//
// A pair of atoms of this rank is listed once, its periodic images too (LIGGGHTS lists both sides
// of an image); a pair with an atom of another rank is listed on both ranks. Partners are numbered:
// atoms of this rank first, then those of other ranks that occur.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact_memory.h"
#include "vec4.h"

namespace LAMMPS_NS {
class Atom;
class Domain;
class NeighList;
}  // namespace LAMMPS_NS

namespace slidewave::dem {

/// A particle as the contact loop sees it: one cache line and a half. SI units.
struct alignas(32) Body {
  Vec4 x;      ///< position; radius
  Vec4 v;      ///< velocity; 1/mass, 0 where it is frozen
  Vec4 omega;  ///< spin; 0
  double radius() const { return x[3]; }
  double inverse_mass() const { return v[3]; }
};

struct alignas(64) Load {
  Vec4 force;
  Vec4 torque;
};

/// In an array: std::vector does not see the alignment of a bare vector type.
struct alignas(32) Slot {
  Vec4 v;
};

struct Neighbour {
  std::int32_t body = 0;
  std::int32_t shift = 0;  ///< which periodic image: x of the body + shifts[shift]
};

class PairList {
 public:
  std::vector<std::size_t> first;  ///< of each atom of this rank, and the end
  std::vector<Neighbour> neighbours;
  std::vector<std::uint8_t> touching;
  std::vector<Slot> history;  ///< `registers` a pair
  std::vector<Slot> shifts;   ///< [m]; the first is 0
  std::vector<Body> bodies;
  std::vector<Load> loads;

  /// `signs`: one a register of history, -1 where a number turns when the partners change places.
  void set_history(std::vector<Slot> const& signs) { signs_ = signs; }
  std::size_t registers() const { return signs_.size(); }

  bool valid() const { return valid_; }
  void invalidate() { valid_ = false; }

  /// From LIGGGHTS' list just built; history comes from `memory`, `frozen` is a group bit.
  void rebuild(LAMMPS_NS::Atom& atom, LAMMPS_NS::Domain const& domain,
               LAMMPS_NS::NeighList const& list, ContactMemory const& memory, int frozen);
  /// Writes the history of touching pairs to both partners, as far as they are of this rank.
  void collect(LAMMPS_NS::Atom& atom, ContactMemory& memory) const;
  /// Positions and velocities of this step. Clears the loads.
  void take(LAMMPS_NS::Atom const& atom);
  /// Adds the loads to the forces of this rank's atoms.
  void give(LAMMPS_NS::Atom& atom) const;

  std::size_t locals() const { return locals_; }
  /// Where LIGGGHTS has the body.
  int atom_of(std::int32_t body) const { return atoms_[static_cast<std::size_t>(body)]; }

 private:
  std::int32_t shift_between(LAMMPS_NS::Domain const& domain, double const* image,
                             double const* owner);

  bool valid_ = false;
  std::size_t locals_ = 0;
  std::vector<Slot> signs_;
  std::vector<int> atoms_;  // of each body
  std::vector<int> tags_;   // when the list was built
};

}  // namespace slidewave::dem
