// What contacts remember, kept with the particles while the neighbour list is rebuilt: through
// migration between ranks, sorting and restarts. A record is known by the partner's id and by where
// the partner stood, so that two periodic images of one partner are two contacts.
//
// One record a contact and side, in doubles:
//
//   id of the partner, vector from partner to particle (3) [m], numbers of history (n)
//
// Between rebuilds the history lives beside the pair (pair_list.h) and these records are stale.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace slidewave::dem {

class ContactMemory {
 public:
  static constexpr std::size_t head = 4;  ///< id and vector

  /// `numbers` of history a contact; forgets everything.
  void reset(std::size_t numbers) {
    numbers_ = numbers;
    for (Place& place : places_) {
      place = {};
    }
    pool_.clear();
  }
  std::size_t numbers() const { return numbers_; }
  std::size_t record() const { return head + numbers_; }

  /// Room for this many particles.
  void grow(std::size_t particles) {
    if (places_.size() < particles) {
      places_.resize(particles);
    }
  }
  void copy(std::size_t from, std::size_t to) { places_[to] = places_[from]; }
  void forget(std::size_t particle) { places_[particle] = {}; }

  std::size_t count(std::size_t particle) const { return places_[particle].count; }
  double const* records(std::size_t particle) const { return &pool_[places_[particle].start]; }

  /// Replaces everything: counts[i] records for particle i; gives where each one's begin.
  void allot(std::vector<std::size_t> const& counts) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      places_[i] = {next, counts[i]};
      next += counts[i] * record();
    }
    pool_.assign(next, 0.0);
  }
  double* writable(std::size_t particle) { return &pool_[places_[particle].start]; }

  /// Takes over `count` records of a particle that has just come.
  void adopt(std::size_t particle, double const* records, std::size_t count) {
    grow(particle + 1);
    places_[particle] = {pool_.size(), count};
    pool_.insert(pool_.end(), records, records + count * record());
  }

  /// History of the contact with `partner` at `branch`, or null. `reach_m`: two images of a partner
  /// lie farther apart than this, and a contact moves less between two looks.
  double const* find(std::size_t particle, int partner, std::array<double, 3> const& branch,
                     double reach_m) const;

 private:
  struct Place {
    std::size_t start = 0;
    std::size_t count = 0;
  };
  std::size_t numbers_ = 0;
  std::vector<Place> places_;
  std::vector<double> pool_;
};

}  // namespace slidewave::dem
