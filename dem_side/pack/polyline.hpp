// A polyline z(x) of a section, both in m, with rising x.
#pragma once

#include <string>
#include <vector>

namespace slidewave::pack {

struct Point {
  double x = 0;
  double z = 0;
};

class Polyline {
 public:
  /// Throws std::runtime_error where there are fewer than two points or x does not rise.
  explicit Polyline(std::vector<Point> points);
  /// Reads a text file of "x z" lines.
  static Polyline read(std::string const& path);

  /// Height at x; beyond the ends the height of the end.
  double height(double x) const;
  /// Moves a disc of this radius that lies less than its radius above the line (or below it) out
  /// to where it touches. Gives how far it had to move [m].
  double push_above(Point& centre, double radius) const;
  /// Distance from a point to the line, negative below it.
  double signed_distance(Point const& point) const;
  std::vector<Point> const& points() const { return points_; }

 private:
  /// Index of the piece over x, clamped to the ends.
  std::size_t piece(double x) const;
  /// The point of the line that is closest to `point`.
  Point closest(Point const& point) const;
  std::vector<Point> points_;
};

}  // namespace slidewave::pack
