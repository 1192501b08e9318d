#include "windows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slidewave {
namespace {

double positive(Scene const& scene, std::string const& key) {
  double const value = scene.number(key);
  if (!(value > 0)) {
    throw InputError((scene.directory() / "case.toml").string(), key, fmt::format("{}", value),
                     "must be a positive time in seconds");
  }
  return value;
}

}  // namespace

Windows::Windows(double window_s, double end_time_s)
    : window_s_(window_s),
      end_s_(end_time_s),
      // a remainder of round-off size is no window of its own
      count_(std::max(1L, static_cast<long>(std::ceil(end_time_s / window_s - 1e-6)))) {}

Windows Windows::of(Scene const& scene) {
  return {positive(scene, "coupling.window"), positive(scene, "case.end_time")};
}

Window Windows::operator[](long index) const {
  Window window;
  window.index = index;
  window.t1_s = index >= count_ ? end_s_ : static_cast<double>(index) * window_s_;
  window.t0_s = index == 0 ? 0 : static_cast<double>(index - 1) * window_s_;
  return window;
}

}  // namespace slidewave
