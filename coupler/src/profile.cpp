#include "profile.hpp"

#include <numeric>

namespace slidewave {

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double Profile::total() const {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

}  // namespace slidewave
