// Lines for the user while the run goes on: time, share done, time left, who waits, the headline.
#pragma once

#include <string>
#include <vector>

#include "sums.hpp"
#include "windows.hpp"

namespace slidewave {

class Progress {
 public:
  /// `headline`: the history column to show; may be empty.
  Progress(double end_s, std::string headline);
  /// The run begins at this time of the case, not at 0.
  void begins_at(double time_s) { begin_share_ = time_s / end_s_; }
  /// The line for this row, or empty: at most one every 2 s and every 2 %.
  std::string line(Window const& window, std::vector<Quantity> const& columns, double dem_wait_s,
                   double fluid_wait_s);

 private:
  double end_s_;
  std::string headline_;
  double start_s_;
  double begin_share_ = 0;
  double spoken_s_ = -1e9;
  double spoken_share_ = -1;
};

}  // namespace slidewave
