#include "signals.hpp"

#include <csignal>
#include <initializer_list>

namespace slidewave {
namespace {

volatile std::sig_atomic_t asked = 0;

extern "C" void note_signal(int number) {
  asked = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

void watch_signals() {
  for (int number : {SIGTERM, SIGINT, SIGUSR1}) {
    std::signal(number, note_signal);
  }
}

bool stop_was_asked() {
  return asked != 0;
}

}  // namespace slidewave
