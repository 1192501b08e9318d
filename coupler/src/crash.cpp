#include "crash.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

namespace slidewave {
namespace {

struct Crash {
  int number;
  char const* name;
  std::string text;  // made beforehand: a handler may not
};

Crash crashes[] = {{SIGSEGV, "segmentation fault (a memory error in an engine)", ""},
                   {SIGABRT, "the program aborted itself", ""},
                   {SIGBUS, "bus error (a memory error, or a file that shrank)", ""},
                   {SIGILL, "illegal instruction (built for another processor?)", ""}};
std::string file;

extern "C" void tell_crash(int number) {
  for (Crash const& crash : crashes) {
    if (crash.number != number || crash.text.empty()) {
      continue;
    }
    int const record = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (record >= 0) {
      (void)!::write(record, crash.text.data(), crash.text.size());
      (void)!::write(STDERR_FILENO, crash.text.data(), crash.text.size());
      ::close(record);
    }
  }
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

void report_crashes(std::filesystem::path const& failure_file, std::string const& who) {
  file = failure_file.string();
  for (Crash& crash : crashes) {
    crash.text = "slidewave: " + who + ": " + crash.name + "\n";
  }
  report_crashes_again();
}

void report_crashes_again() {
  for (Crash const& crash : crashes) {
    std::signal(crash.number, tell_crash);
  }
}

}  // namespace slidewave
