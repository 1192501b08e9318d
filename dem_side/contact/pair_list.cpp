#include "pair_list.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "domain.h"
#include "lmptype.h"
#include "neigh_list.h"

namespace slidewave::dem {
namespace {

std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

// Half of the sum of the radii: images of one partner are at least a diameter apart.
double reach(Body const& a, Body const& b) {
  return 0.5 * (a.radius + b.radius);
}

}  // namespace

std::int32_t PairList::shift_between(LAMMPS_NS::Domain const& domain, double const* image,
                                     double const* owner) {
  std::array<double, 3> shift{};
  for (std::size_t k = 0; k < 3; ++k) {
    double const period = domain.prd[k];
    shift[k] = domain.periodicity[k] ? period * std::round((image[k] - owner[k]) / period) : 0.0;
  }
  auto const known = std::find(shifts.begin(), shifts.end(), shift);
  auto const place = known - shifts.begin();
  if (known == shifts.end()) {
    shifts.push_back(shift);
  }
  return static_cast<std::int32_t>(place);
}

void PairList::rebuild(LAMMPS_NS::Atom& atom, LAMMPS_NS::Domain const& domain,
                       LAMMPS_NS::NeighList const& list, ContactMemory const& memory, int frozen) {
  locals_ = index(atom.nlocal);
  int const all = atom.nlocal + atom.nghost;
  first.assign(locals_ + 1, 0);
  neighbours.clear();
  shifts.assign(1, {});
  atoms_.resize(locals_);
  for (std::size_t i = 0; i < locals_; ++i) {
    atoms_[i] = static_cast<int>(i);
  }
  std::vector<std::int32_t> body_of_ghost(index(all) - locals_, -1);

  for (int row = 0; row < list.inum; ++row) {
    int const i = list.ilist[row];  // rows are in the order of the atoms
    int const* const partners = list.firstneigh[i];
    for (int k = 0; k < list.numneigh[i]; ++k) {
      int const j = partners[k] & NEIGHMASK;
      if (j < atom.nlocal) {
        neighbours.push_back({j, 0});
        continue;
      }
      int const owner = atom.map(atom.tag[j]);
      if (owner >= 0 && owner < atom.nlocal) {
        if (atom.tag[i] < atom.tag[j]) {
          neighbours.push_back({owner, shift_between(domain, atom.x[j], atom.x[owner])});
        }
        continue;
      }
      std::int32_t& body = body_of_ghost[index(j - atom.nlocal)];
      if (body < 0) {
        body = static_cast<std::int32_t>(atoms_.size());
        atoms_.push_back(j);
      }
      neighbours.push_back({body, 0});
    }
    first[index(i) + 1] = neighbours.size();
  }
  tags_.resize(atoms_.size());
  for (std::size_t b = 0; b < atoms_.size(); ++b) {
    tags_[b] = atom.tag[atoms_[b]];
  }
  bodies.resize(atoms_.size());
  loads.resize(atoms_.size());
  for (std::size_t b = 0; b < atoms_.size(); ++b) {
    int const i = atoms_[b];
    bodies[b].inverse_mass = atom.mask[i] & frozen ? 0.0 : 1 / atom.rmass[i];
  }
  take(atom);

  touching.assign(neighbours.size(), 0);
  history.assign(neighbours.size() * numbers(), 0.0);
  for (std::size_t i = 0; i < locals_; ++i) {
    if (memory.count(i) == 0) {
      continue;
    }
    for (std::size_t pair = first[i]; pair < first[i + 1]; ++pair) {
      Body const& partner = bodies[index(neighbours[pair].body)];
      auto const& shift = shifts[index(neighbours[pair].shift)];
      std::array<double, 3> branch{};
      for (std::size_t k = 0; k < 3; ++k) {
        branch[k] = bodies[i].x[k] - (partner.x[k] + shift[k]);
      }
      double const* const kept =
          memory.find(i, tags_[index(neighbours[pair].body)], branch, reach(bodies[i], partner));
      if (kept) {
        std::copy_n(kept, numbers(), history.begin() + static_cast<long>(pair * numbers()));
        touching[pair] = 1;
      }
    }
  }
  valid_ = true;
}

void PairList::collect(LAMMPS_NS::Atom& atom, ContactMemory& memory) const {
  // Atoms may have been moved or deleted since the list was built.
  std::vector<int> now(locals_);
  for (std::size_t i = 0; i < locals_; ++i) {
    bool const stays = static_cast<int>(i) < atom.nlocal && atom.tag[i] == tags_[i];
    int const found = stays ? static_cast<int>(i) : atom.map(tags_[i]);
    now[i] = found < atom.nlocal ? found : -1;
  }
  std::vector<std::size_t> counts(static_cast<std::size_t>(atom.nlocal), 0);
  auto const local = [&](std::size_t body) { return body < locals_ && now[body] >= 0; };
  auto const each_side = [&](auto const& what) {
    for (std::size_t i = 0; i < locals_; ++i) {
      for (std::size_t pair = first[i]; pair < first[i + 1]; ++pair) {
        if (touching[pair]) {
          std::size_t const j = index(neighbours[pair].body);
          if (local(i)) {
            what(pair, i, j, 1.0);
          }
          if (local(j)) {
            what(pair, j, i, -1.0);
          }
        }
      }
    }
  };
  each_side([&](std::size_t, std::size_t i, std::size_t, double) { ++counts[index(now[i])]; });
  memory.allot(counts);
  std::fill(counts.begin(), counts.end(), 0);
  each_side([&](std::size_t pair, std::size_t i, std::size_t j, double side) {
    std::size_t const owner = index(now[i]);
    double* const out = memory.writable(owner) + memory.record() * counts[owner]++;
    out[0] = tags_[j];
    auto const& shift = shifts[index(neighbours[pair].shift)];
    for (std::size_t k = 0; k < 3; ++k) {
      out[k + 1] = bodies[i].x[k] - bodies[j].x[k] - side * shift[k];
    }
    for (std::size_t k = 0; k < numbers(); ++k) {
      double const kept = history[pair * numbers() + k];
      out[ContactMemory::head + k] = side < 0 ? signs_[k] * kept : kept;
    }
  });
}

void PairList::take(LAMMPS_NS::Atom const& atom) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    int const i = atoms_[b];
    Body& body = bodies[b];
    for (std::size_t k = 0; k < 3; ++k) {
      body.x[k] = atom.x[i][k];
      body.v[k] = atom.v[i][k];
      body.omega[k] = atom.omega[i][k];
    }
    body.radius = atom.radius[i];
    loads[b] = {};
  }
}

void PairList::give(LAMMPS_NS::Atom& atom) const {
  for (std::size_t i = 0; i < locals_; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      atom.f[i][k] += loads[i].force[k];
      atom.torque[i][k] += loads[i].torque[k];
    }
  }
}

}  // namespace slidewave::dem
