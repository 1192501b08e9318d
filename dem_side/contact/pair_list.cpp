#include "pair_list.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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
  return 0.5 * (a.radius() + b.radius());
}

}  // namespace

std::int32_t PairList::shift_between(LAMMPS_NS::Domain const& domain, double const* image,
                                     double const* owner) {
  Vec4 shift{};
  for (int k = 0; k < 3; ++k) {
    double const period = domain.prd[k];
    shift[k] = domain.periodicity[k] ? period * std::round((image[k] - owner[k]) / period) : 0.0;
  }
  auto const known = std::find_if(shifts.begin(), shifts.end(), [&](Slot const& other) {
    Vec4 const apart = other.v - shift;
    return dot(apart, apart) == 0;
  });
  auto const place = known - shifts.begin();
  if (known == shifts.end()) {
    shifts.push_back({shift});
  }
  return static_cast<std::int32_t>(place);
}

void PairList::rebuild(LAMMPS_NS::Atom& atom, LAMMPS_NS::Domain const& domain,
                       LAMMPS_NS::NeighList const& list, ContactMemory const& memory, int frozen) {
  locals_ = index(atom.nlocal);
  int const all = atom.nlocal + atom.nghost;
  first.assign(locals_ + 1, 0);
  neighbours.clear();
  shifts.assign(1, Slot{Vec4{}});
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
    bodies[b].v[3] = atom.mask[i] & frozen ? 0.0 : 1 / atom.rmass[i];
  }
  take(atom);

  touching.assign(neighbours.size(), 0);
  history.assign(neighbours.size() * registers(), Slot{Vec4{}});
  for (std::size_t i = 0; i < locals_; ++i) {
    if (memory.count(i) == 0) {
      continue;
    }
    for (std::size_t pair = first[i]; pair < first[i + 1]; ++pair) {
      Body const& partner = bodies[index(neighbours[pair].body)];
      Vec4 const apart = bodies[i].x - (partner.x + shifts[index(neighbours[pair].shift)].v);
      double const* const kept =
          memory.find(i, tags_[index(neighbours[pair].body)], {apart[0], apart[1], apart[2]},
                      reach(bodies[i], partner));
      if (kept) {
        std::memcpy(&history[pair * registers()], kept, registers() * sizeof(Slot));
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
    Vec4 const apart = bodies[i].x - bodies[j].x - side * shifts[index(neighbours[pair].shift)].v;
    store3(apart, out + 1);
    for (std::size_t k = 0; k < registers(); ++k) {
      Vec4 const kept = history[pair * registers() + k].v;
      Vec4 const turned = side < 0 ? signs_[k].v * kept : kept;
      std::memcpy(out + ContactMemory::head + 4 * k, &turned, sizeof(Vec4));
    }
  });
}

void PairList::take(LAMMPS_NS::Atom const& atom) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    int const i = atoms_[b];
    Body& body = bodies[b];
    double const* const x = atom.x[i];
    double const* const v = atom.v[i];
    double const* const omega = atom.omega[i];
    body.x = Vec4{x[0], x[1], x[2], atom.radius[i]};
    body.v = Vec4{v[0], v[1], v[2], body.v[3]};
    body.omega = load3(omega);
    loads[b] = Load{Vec4{}, Vec4{}};
  }
}

void PairList::give(LAMMPS_NS::Atom& atom) const {
  for (std::size_t i = 0; i < locals_; ++i) {
    for (int k = 0; k < 3; ++k) {
      atom.f[i][k] += loads[i].force[k];
      atom.torque[i][k] += loads[i].torque[k];
    }
  }
}

}  // namespace slidewave::dem
