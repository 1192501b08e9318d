// Overlap removal. Pairs are found on a grid of cubes as wide as the largest sphere; the few
// hundred passes of a scene cost seconds, so nothing cleverer is needed.
#include <algorithm>
#include <cmath>

#include "spheres.hpp"

namespace slidewave::pack {

namespace {

/// Spheres sorted into cubes. y is periodic: cubes divide the width without remainder, and where
/// fewer than three fit, every row is searched once, so that no pair is met twice.
class Grid {
 public:
  Grid(Room const& room, std::vector<Sphere> const& spheres) : width_(room.width) {
    double largest = 0;
    double x1 = -1e300;
    double z1 = -1e300;
    for (auto const& s : spheres) {
      largest = std::max(largest, 2 * s.radius);
      x0_ = std::min(x0_, s.x);
      z0_ = std::min(z0_, s.z);
      x1 = std::max(x1, s.x);
      z1 = std::max(z1, s.z);
    }
    size_ = largest;
    rows_ = std::max(1, static_cast<int>(width_ / size_));
    nx_ = static_cast<int>((x1 - x0_) / size_) + 1;
    nz_ = static_cast<int>((z1 - z0_) / size_) + 1;
    first_.assign(static_cast<std::size_t>(nx_) * rows_ * nz_ + 1, 0);
    cube_.resize(spheres.size());
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      cube_[i] = cube(spheres[i]);
      ++first_[cube_[i] + 1];
    }
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    member_.resize(spheres.size());
    auto next = first_;
    for (std::size_t i = 0; i < spheres.size(); ++i) member_[next[cube_[i]]++] = i;
  }

  /// Calls visit(i, j) once for each pair in the same or in neighbouring cubes.
  template <class Visit>
  void pairs(Visit&& visit) const {
    for (int ix = 0; ix < nx_; ++ix) {
      for (int iy = 0; iy < rows_; ++iy) {
        for (int iz = 0; iz < nz_; ++iz) around(ix, iy, iz, visit);
      }
    }
  }

 private:
  std::size_t index(int ix, int iy, int iz) const {
    return (static_cast<std::size_t>(ix) * rows_ + iy) * nz_ + iz;
  }

  std::size_t cube(Sphere const& s) const {
    int const iy = std::clamp(static_cast<int>(s.y / width_ * rows_), 0, rows_ - 1);
    return index(static_cast<int>((s.x - x0_) / size_), iy, static_cast<int>((s.z - z0_) / size_));
  }

  template <class Visit>
  void around(int ix, int iy, int iz, Visit&& visit) const {
    auto const here = index(ix, iy, iz);
    int const y_from = rows_ < 3 ? 0 : iy - 1;
    int const y_to = rows_ < 3 ? rows_ - 1 : iy + 1;
    for (int jx = std::max(0, ix - 1); jx <= std::min(nx_ - 1, ix + 1); ++jx) {
      for (int y = y_from; y <= y_to; ++y) {
        for (int jz = std::max(0, iz - 1); jz <= std::min(nz_ - 1, iz + 1); ++jz) {
          auto const there = index(jx, (y + rows_) % rows_, jz);
          if (there < here) continue;
          for (auto a = first_[here]; a < first_[here + 1]; ++a) {
            for (auto b = there == here ? a + 1 : first_[there]; b < first_[there + 1]; ++b) {
              visit(member_[a], member_[b]);
            }
          }
        }
      }
    }
  }

  double width_;
  double size_ = 0;
  double x0_ = 1e300;
  double z0_ = 1e300;
  int nx_ = 0;
  int rows_ = 0;
  int nz_ = 0;
  std::vector<std::size_t> first_;
  std::vector<std::size_t> cube_;
  std::vector<std::size_t> member_;
};

double nearest_image(double dy, double width) {
  return dy - width * std::round(dy / width);
}

/// In diameters of the smaller sphere, negative where they do not touch.
double pair_overlap(Room const& room, Sphere const& a, Sphere const& b) {
  double const dy = nearest_image(b.y - a.y, room.width);
  double const depth = a.radius + b.radius - std::hypot(b.x - a.x, dy, b.z - a.z);
  return depth / (2 * std::min(a.radius, b.radius));
}

double base_overlap(Room const& room, Sphere const& s) {
  return (s.radius - room.base.signed_distance({s.x, s.z})) / (2 * s.radius);
}

void keep_inside(Room const& room, Sphere& s) {
  Point centre{s.x, s.z};
  centre.z = std::min(centre.z, room.top.height(centre.x) + room.margin);
  centre.x = std::clamp(centre.x, room.head(), room.toe() - s.radius);
  room.base.push_above(centre, s.radius);
  s.x = centre.x;
  s.z = centre.z;
  s.y -= room.width * std::floor(s.y / room.width);
}

}  // namespace

void separate(Room const& room, std::vector<Sphere>& spheres) {
  if (spheres.empty()) return;
  Grid(room, spheres).pairs([&](std::size_t i, std::size_t j) {
    auto& a = spheres[i];
    auto& b = spheres[j];
    double const reach = a.radius + b.radius;
    double const dx = b.x - a.x;
    double const dz = b.z - a.z;
    if (std::abs(dx) >= reach || std::abs(dz) >= reach) return;
    double const nearest = nearest_image(b.y - a.y, room.width);
    // In a room thinner than two spheres a pair can overlap through both faces.
    for (double const dy : {nearest, nearest - std::copysign(room.width, nearest)}) {
      double const square = dx * dx + dy * dy + dz * dz;
      if (square >= reach * reach) continue;
      double const distance = std::sqrt(square);
      // Coinciding centres: any direction will do.
      double const half = 0.5 * (reach - distance) / std::max(distance, 1e-9);
      double const ux = distance > 1e-9 ? dx : 1e-9;
      a.x -= half * ux;
      a.y -= half * dy;
      a.z -= half * dz;
      b.x += half * ux;
      b.y += half * dy;
      b.z += half * dz;
    }
  });
  for (auto& s : spheres) keep_inside(room, s);
}

void drop_crowded(Room const& room, std::vector<Sphere>& spheres, double limit) {
  if (spheres.empty()) return;
  std::vector<char> crowded(spheres.size(), 0);
  Grid(room, spheres).pairs([&](std::size_t i, std::size_t j) {
    auto const smaller = spheres[i].radius < spheres[j].radius ? i : j;
    if (crowded[i] || crowded[j]) return;
    crowded[smaller] = pair_overlap(room, spheres[i], spheres[j]) > limit;
  });
  std::vector<Sphere> kept;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    if (!crowded[i] && base_overlap(room, spheres[i]) <= limit) kept.push_back(spheres[i]);
  }
  spheres = std::move(kept);
}

Overlap measure_overlap(Room const& room, std::vector<Sphere> const& spheres) {
  Overlap result;
  if (spheres.empty()) return result;
  double sum = 0;
  long touching = 0;
  Grid(room, spheres).pairs([&](std::size_t i, std::size_t j) {
    double const relative = pair_overlap(room, spheres[i], spheres[j]);
    if (relative <= 0) return;
    result.largest = std::max(result.largest, relative);
    sum += relative;
    ++touching;
  });
  for (auto const& s : spheres) {
    result.largest = std::max(result.largest, base_overlap(room, s));
  }
  result.mean = touching ? sum / static_cast<double>(touching) : 0;
  return result;
}

}  // namespace slidewave::pack
