#include "polyline.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace slidewave::pack {

Polyline::Polyline(std::vector<Point> points) : points_(std::move(points)) {
  if (points_.size() < 2) throw std::runtime_error("a polyline needs at least two points");
  for (std::size_t i = 1; i < points_.size(); ++i) {
    if (points_[i].x <= points_[i - 1].x) throw std::runtime_error("a polyline's x must rise");
  }
}

Polyline Polyline::read(std::string const& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::vector<Point> points;
  Point point;
  while (file >> point.x >> point.z) points.push_back(point);
  if (!file.eof()) throw std::runtime_error(path + ": not a list of \"x z\" lines");
  return Polyline(std::move(points));
}

std::size_t Polyline::piece(double x) const {
  auto const after = std::upper_bound(points_.begin(), points_.end(), x,
                                      [](double value, Point const& p) { return value < p.x; });
  auto const index = after - points_.begin() - 1;
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(points_.size()) - 2));
}

double Polyline::height(double x) const {
  x = std::clamp(x, points_.front().x, points_.back().x);
  auto const i = piece(x);
  auto const& a = points_[i];
  auto const& b = points_[i + 1];
  return a.z + (b.z - a.z) * (x - a.x) / (b.x - a.x);
}

Point Polyline::closest(Point const& point) const {
  // Pieces outside x +- (distance straight down) cannot hold a closer point than that one.
  double best = std::abs(point.z - height(point.x));
  double const reach = best;
  Point found{point.x, height(point.x)};
  for (auto i = piece(point.x - reach); i <= piece(point.x + reach); ++i) {
    auto const& a = points_[i];
    auto const& b = points_[i + 1];
    double const dx = b.x - a.x;
    double const dz = b.z - a.z;
    double const along =
        std::clamp(((point.x - a.x) * dx + (point.z - a.z) * dz) / (dx * dx + dz * dz), 0.0, 1.0);
    Point const candidate{a.x + along * dx, a.z + along * dz};
    double const distance = std::hypot(point.x - candidate.x, point.z - candidate.z);
    if (distance < best) {
      best = distance;
      found = candidate;
    }
  }
  return found;
}

double Polyline::signed_distance(Point const& point) const {
  auto const foot = closest(point);
  double const distance = std::hypot(point.x - foot.x, point.z - foot.z);
  return point.z >= height(point.x) ? distance : -distance;
}

double Polyline::push_above(Point& centre, double radius) const {
  // Far above the line, which is the rule, no foot is needed: the steepest piece decides.
  double const above = centre.z - height(centre.x);
  if (above > 4 * radius) return 0;
  auto const foot = closest(centre);
  double const distance = std::hypot(centre.x - foot.x, centre.z - foot.z);
  if (above > 0 && distance >= radius) return 0;
  if (above <= 0 || distance < 1e-9 * radius) {
    // Below, or on the line: straight up is always out.
    double const moved = radius - above;
    centre.z += moved;
    return moved;
  }
  double const moved = radius - distance;
  centre.x += (centre.x - foot.x) / distance * moved;
  centre.z += (centre.z - foot.z) / distance * moved;
  return moved;
}

}  // namespace slidewave::pack
