#include "error_route.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

namespace slidewave::lammps {
namespace {

Session const* ends_here = nullptr;
std::filesystem::path log_file;
int depth = 0;

bool at_work() {
  return ends_here && depth > 0;
}

/// The last error in the log with the script line that LAMMPS prints below it; empty for none.
std::string last_words() {
  std::ifstream in(log_file);
  std::string line, found;
  while (std::getline(in, line)) {
    if (line.rfind("ERROR", 0) == 0) {
      found = line;
    } else if (line.rfind("Last command:", 0) == 0 && !found.empty()) {
      found += "; " + line;
    }
  }
  return found;
}

[[noreturn]] void die() {
  std::fflush(nullptr);  // LAMMPS' last words are still in a buffer
  if (ends_here->rank() != 0) {
    // Error::all prints on the first rank only: let that one speak.
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  }
  std::string const words = last_words();
  ends_here->fail(
      (words.empty() ? "LAMMPS ended itself (quit in the script?)" : "LAMMPS: " + words) +
      " (see " + log_file.string() + ")");
}

}  // namespace

void route_errors(Session const& session, std::filesystem::path log) {
  ends_here = &session;
  log_file = std::move(log);
}

InsideLammps::InsideLammps() {
  ++depth;
}
InsideLammps::~InsideLammps() {
  --depth;
}

}  // namespace slidewave::lammps

extern "C" {

int MPI_Finalize() {
  if (slidewave::lammps::at_work()) {
    slidewave::lammps::die();
  }
  return PMPI_Finalize();
}

int MPI_Abort(MPI_Comm comm, int code) {
  if (slidewave::lammps::at_work()) {
    slidewave::lammps::die();
  }
  return PMPI_Abort(comm, code);
}
}
