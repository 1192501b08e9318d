// The spheres of a packing: positions [m] and radii [m], periodic in y.
#pragma once

#include <cstdint>
#include <vector>

#include "polyline.hpp"

namespace slidewave::pack {

struct Sphere {
  double x = 0;
  double y = 0;
  double z = 0;
  double radius = 0;
};

double volume(Sphere const& sphere);

/// Where spheres may be: above `base`, centres below `top` + margin, x up to a plane at the toe.
struct Room {
  Polyline base;
  Polyline top;
  double width = 0;   ///< period in y
  double margin = 0;  ///< how far above `top` centres may be

  double toe() const { return top.points().back().x; }
  double head() const { return top.points().front().x; }
  /// Area between base and top [m2], by exact trapezia.
  double area() const;
};

/// Diameters, uniform between the two bounds [m].
struct Diameters {
  double least = 0;
  double most = 0;
};

/// Spheres at random points of the room, until their volume is `solid_fraction` of its volume.
/// They overlap. The same seed gives the same spheres on every machine.
std::vector<Sphere> scatter(Room const& room, Diameters const& diameters, double solid_fraction,
                            std::uint64_t seed);

struct Overlap {
  double largest = 0;  ///< of pairs and of spheres with the base, in diameters of the smaller one
  double mean = 0;     ///< over the pairs that touch
};

/// One position-based pass: every overlapping pair moves apart along its centre line until it just
/// touches, then every sphere moves back into the room.
void separate(Room const& room, std::vector<Sphere>& spheres);

/// Takes out one sphere, the smaller, of each pair that overlaps by more than `limit` of its
/// diameter, and each that is so deep in the base: passes cannot mend corners without room.
void drop_crowded(Room const& room, std::vector<Sphere>& spheres, double limit);

Overlap measure_overlap(Room const& room, std::vector<Sphere> const& spheres);

/// Keeps the spheres with centres below `top` and x at most toe - gap [m].
std::vector<Sphere> trim(Room const& room, std::vector<Sphere> const& spheres, double gap);

/// Volume of the spheres over the volume of the room without its margin.
double solid_fraction(Room const& room, std::vector<Sphere> const& spheres);

}  // namespace slidewave::pack
