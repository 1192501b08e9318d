#include "routes.hpp"

#include <algorithm>
#include <limits>

namespace slidewave {
namespace {

bool holds(Box const& box, Vec3 const& point, double margin) {
  return (point.array() >= box.low.array() - margin).all() &&
         (point.array() <= box.high.array() + margin).all();
}

}  // namespace

int CoarseMap::first(Vec3 const& point_m, double margin_m) const {
  auto const found = std::find_if(boxes_.begin(), boxes_.end(),
                                  [&](Box const& box) { return holds(box, point_m, margin_m); });
  return found == boxes_.end() ? -1 : static_cast<int>(found - boxes_.begin());
}

void CoarseMap::others(Vec3 const& point_m, double margin_m, int except,
                       std::vector<int>& ranks) const {
  ranks.clear();
  for (int r = 0; r < static_cast<int>(boxes_.size()); ++r) {
    if (r != except && holds(boxes_[r], point_m, margin_m)) {
      ranks.push_back(r);
    }
  }
}

double CoarseMap::distance_m(Vec3 const& point_m) const {
  double least = std::numeric_limits<double>::infinity();
  for (Box const& box : boxes_) {
    Vec3 const outside = (box.low - point_m).cwiseMax(point_m - box.high).cwiseMax(Vec3::Zero());
    least = std::min(least, outside.norm());
  }
  return least;
}

void Groups::sort(std::vector<int> const& destination, int destinations) {
  start_.assign(destinations + 1, 0);
  for (int d : destination) {
    if (d >= 0) {
      ++start_[d + 1];
    }
  }
  used_.clear();
  for (int d = 0; d < destinations; ++d) {
    if (start_[d + 1] > 0) {
      used_.push_back(d);
    }
    start_[d + 1] += start_[d];
  }
  rows_.resize(start_[destinations]);
  next_.assign(start_.begin(), start_.end());
  for (std::size_t row = 0; row < destination.size(); ++row) {
    if (destination[row] >= 0) {
      rows_[next_[destination[row]]++] = static_cast<int>(row);
    }
  }
}

}  // namespace slidewave
