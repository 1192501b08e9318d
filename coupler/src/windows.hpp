// The sequence of windows, the same on both sides: window 0 has zero length, the last one ends
// exactly at the end of the case.
#pragma once

#include "slidewave/engine.hpp"
#include "slidewave/scene.hpp"

namespace slidewave {

class Windows {
 public:
  Windows(double window_s, double end_time_s);
  static Windows of(Scene const& scene);
  /// Number of windows after window 0.
  long count() const { return count_; }
  Window operator[](long index) const;
  double end_s() const { return end_s_; }

 private:
  double window_s_;
  double end_s_;
  long count_;
};

}  // namespace slidewave
