#include "slidewave/screen.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace slidewave {

void send_screen_to(std::filesystem::path const& log, Session const& session) {
  if (session.rank() == 0 && !std::filesystem::exists(log.parent_path() / "checkpoints")) {
    std::ofstream const emptied(log);
  }
  MPI_Barrier(session.comm());
  std::fflush(stdout);
  int const file = ::open(log.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) {
    throw std::runtime_error("cannot write " + log.string());
  }
  ::dup2(file, STDOUT_FILENO);
  ::close(file);
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
}

}  // namespace slidewave
