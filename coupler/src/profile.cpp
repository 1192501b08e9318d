#include "profile.hpp"

#include <ctime>
#include <numeric>

namespace slidewave {

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double Profile::total() const {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

double Profile::processor_total() const {
  return std::accumulate(processor_seconds.begin(), processor_seconds.end(), 0.0);
}

}  // namespace slidewave
