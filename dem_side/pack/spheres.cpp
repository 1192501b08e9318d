#include "spheres.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace slidewave::pack {

namespace {

double constexpr kPi = 3.14159265358979323846;

/// std::uniform_real_distribution differs between libraries; the generator itself does not.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace

double volume(Sphere const& sphere) {
  return 4.0 / 3.0 * kPi * sphere.radius * sphere.radius * sphere.radius;
}

double Room::area() const {
  std::vector<double> stops{head(), toe()};
  for (auto const& line : {&base, &top}) {
    for (auto const& point : line->points()) {
      if (point.x > head() && point.x < toe()) stops.push_back(point.x);
    }
  }
  std::sort(stops.begin(), stops.end());
  double sum = 0;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    double const a = std::max(0.0, top.height(stops[i - 1]) - base.height(stops[i - 1]));
    double const b = std::max(0.0, top.height(stops[i]) - base.height(stops[i]));
    sum += 0.5 * (a + b) * (stops[i] - stops[i - 1]);
  }
  return sum;
}

std::vector<Sphere> scatter(Room const& room, Diameters const& diameters, double wanted,
                            std::uint64_t seed) {
  double tallest = 0;
  for (auto const& line : {&room.base, &room.top}) {
    for (auto const& p : line->points()) {
      if (p.x < room.head() || p.x > room.toe()) continue;
      tallest = std::max(tallest, room.top.height(p.x) - room.base.height(p.x));
    }
  }
  if (tallest <= 0) throw std::runtime_error("there is no room between base and top");
  tallest += room.margin;
  double const length = room.toe() - room.head();
  double const target = wanted * (room.area() + room.margin * length) * room.width;
  std::mt19937_64 random(seed);
  std::vector<Sphere> spheres;
  for (double filled = 0; filled < target;) {
    Sphere s;
    s.x = room.head() + length * uniform(random);
    double const above = tallest * uniform(random);
    double const base = room.base.height(s.x);
    s.y = room.width * uniform(random);
    s.radius = 0.5 * (diameters.least + (diameters.most - diameters.least) * uniform(random));
    if (base + above > room.top.height(s.x) + room.margin) continue;
    s.z = base + above;
    spheres.push_back(s);
    filled += volume(s);
  }
  return spheres;
}

std::vector<Sphere> trim(Room const& room, std::vector<Sphere> const& spheres, double gap) {
  std::vector<Sphere> kept;
  for (auto const& s : spheres) {
    if (s.x >= room.head() && s.x <= room.toe() - gap && s.z <= room.top.height(s.x)) {
      kept.push_back(s);
    }
  }
  return kept;
}

double solid_fraction(Room const& room, std::vector<Sphere> const& spheres) {
  double sum = 0;
  for (auto const& s : spheres) sum += volume(s);
  return sum / (room.area() * room.width);
}

}  // namespace slidewave::pack
