#include "wait.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace slidewave {

bool Waiter::Attempt::back_off() {
  ++tries;
  if (tries <= 30) {
    sched_yield();
    return false;
  }
  long const microseconds = std::min(200L, 5 * (tries - 30));
  std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
  double const now = now_s();
  if (now - checked_s < 0.1) {
    return false;
  }
  checked_s = now;
  return true;
}

bool Waiter::must_speak(Attempt& attempt) const {
  if (!joining_ && attempt.checked_s - attempt.watched_s > 1) {
    attempt.watched_s = attempt.checked_s;
    if (failure_.another_failed()) {
      std::this_thread::sleep_for(
          std::chrono::seconds(2));  // its MPI_Abort ends this one, if it can
      std::_Exit(1);
    }
  }
  return attempt.checked_s - attempt.start_s > patience_s_ ||
         (speaks_ && attempt.checked_s - attempt.spoken_s > 30);
}

void Waiter::remind(Attempt& attempt, std::string const& awaited) const {
  double const waited = attempt.checked_s - attempt.start_s;
  if (waited > patience_s_) {
    std::string const limit =
        joining_
            ? "the time in which programs must join"
            : fmt::format("coupling.patience = {:.3g} s; raise it if a window may take so long",
                          patience_s_);
    failure_.fail(fmt::format("waited {:.3g} s for {}, longer than {}", waited, awaited, limit), 1);
  }
  attempt.spoken_s = attempt.checked_s;
  failure_.terminal().say(
      fmt::format("slidewave: {} has waited {:.0f} s for {}", failure_.who(), waited, awaited));
}

}  // namespace slidewave
