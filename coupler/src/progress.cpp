#include "progress.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slidewave {
namespace {

std::string clock_text(double seconds) {
  long const s = std::lround(seconds);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

Progress::Progress(double end_s, std::string headline)
    : end_s_(end_s), headline_(std::move(headline)), start_s_(now_s()) {}

std::string Progress::line(Window const& window, std::vector<Quantity> const& columns,
                           double dem_wait_s, double fluid_wait_s) {
  double const now = now_s();
  double const share = window.t1_s / end_s_;
  bool const last = share >= 1;
  if (!last && (now - spoken_s_ < 2 || (share - spoken_share_ < 0.02 && now - spoken_s_ < 20))) {
    return "";
  }
  spoken_s_ = now;
  spoken_share_ = share;
  double const elapsed = now - start_s_;
  std::string line = fmt::format("t = {:.4g} s  {:3.0f} %", window.t1_s, 100 * share);
  if (share > begin_share_) {
    line += fmt::format("  left {}", clock_text(elapsed * (1 - share) / (share - begin_share_)));
  }
  if (elapsed > 0 && (dem_wait_s > 0 || fluid_wait_s > 0)) {
    line += fmt::format("  waiting: fluid {:.0f} %, dem {:.0f} %", 100 * fluid_wait_s / elapsed,
                        100 * dem_wait_s / elapsed);
  }
  for (Quantity const& column : columns) {
    if (column.name == headline_) {
      line += fmt::format("  {} {:.4g}", column.name, column.value);
    }
  }
  return line;
}

}  // namespace slidewave
