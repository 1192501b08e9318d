// To which fluid ranks a particle may belong, and rows grouped by where they go.
#pragma once

#include <vector>

#include "slidewave/engine.hpp"

namespace slidewave {

/// The fluid ranks' boxes: a coarse map of space. A few numbers a fluid rank, looked at only for
/// particles without a known owner.
class CoarseMap {
 public:
  explicit CoarseMap(std::vector<Box> boxes) : boxes_(std::move(boxes)) {}
  /// The lowest rank whose box, larger by `margin_m` on all sides, holds the point; -1: none.
  int first(Vec3 const& point_m, double margin_m) const;
  /// All such ranks but `except`, in order.
  void others(Vec3 const& point_m, double margin_m, int except, std::vector<int>& ranks) const;
  /// How far the point is from the nearest box [m].
  double distance_m(Vec3 const& point_m) const;

 private:
  std::vector<Box> boxes_;
};

/// Rows by destination, in their order (counting sort; memory is kept from call to call).
class Groups {
 public:
  /// destination[row] < 0: the row goes nowhere.
  void sort(std::vector<int> const& destination, int destinations);
  int size() const { return static_cast<int>(used_.size()); }
  int destination(int group) const { return used_[group]; }
  /// The rows of a group, a range into one array.
  int const* rows(int group) const { return rows_.data() + start_[used_[group]]; }
  long count(int group) const { return start_[used_[group] + 1] - start_[used_[group]]; }

 private:
  std::vector<int> used_;
  std::vector<long> start_;
  std::vector<long> next_;
  std::vector<int> rows_;
};

}  // namespace slidewave
