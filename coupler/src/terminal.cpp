#include "terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace slidewave {
namespace {

void write_line(int descriptor, std::string line) {
  line += '\n';
  std::size_t written = 0;
  while (written < line.size()) {
    ssize_t const n = ::write(descriptor, line.data() + written, line.size() - written);
    if (n <= 0) {
      return;  // a closed terminal is no reason to end a run
    }
    written += static_cast<std::size_t>(n);
  }
}

}  // namespace

Terminal::Terminal()
    : out_(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3)),
      err_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {}

Terminal::~Terminal() {
  ::close(out_);
  ::close(err_);
}

void Terminal::say(std::string const& line) const {
  write_line(out_, line);
}

void Terminal::complain(std::string const& line) const {
  write_line(err_, line);
}

}  // namespace slidewave
