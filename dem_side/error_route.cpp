#include "error_route.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

#include "registry.h"

namespace slidewave::dem {
namespace {

Session const* ends_here = nullptr;
std::filesystem::path log_file;
LAMMPS_NS::LAMMPS* quoted = nullptr;
int depth = 0;

bool at_work() {
  return ends_here && depth > 0;
}

std::string last_error_line() {
  std::ifstream in(log_file);
  std::string line;
  std::string found;
  while (std::getline(in, line)) {
    if (line.rfind("ERROR", 0) == 0) {
      found = line;
    }
  }
  return found;
}

[[noreturn]] void die() {
  std::fflush(nullptr);  // LIGGGHTS' last words are still in a buffer
  if (ends_here->rank() != 0) {
    // Error::all prints on the first rank only: let that one speak.
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  }
  std::string reason = last_error_line();
  reason = reason.empty() ? "LIGGGHTS ended itself (quit in the script?)" : "LIGGGHTS: " + reason;
  std::string const line = quoted ? last_script_line(*quoted) : "";
  if (!line.empty()) {
    reason += "; last line of the script: " + line.substr(0, line.find_last_not_of("\n ") + 1);
  }
  ends_here->fail(reason + " (see " + log_file.string() + ")");
}

}  // namespace

void route_errors(Session const& session, std::filesystem::path log) {
  ends_here = &session;
  log_file = std::move(log);
}

void quote_script_of(LAMMPS_NS::LAMMPS* lmp) {
  quoted = lmp;
}

InsideLiggghts::InsideLiggghts() {
  ++depth;
}
InsideLiggghts::~InsideLiggghts() {
  --depth;
}

}  // namespace slidewave::dem

extern "C" {

int MPI_Finalize() {
  if (slidewave::dem::at_work()) {
    slidewave::dem::die();
  }
  return PMPI_Finalize();
}

int MPI_Abort(MPI_Comm comm, int code) {
  if (slidewave::dem::at_work()) {
    slidewave::dem::die();
  }
  return PMPI_Abort(comm, code);
}

int MPI_Comm_dup(MPI_Comm comm, MPI_Comm* copy) {
  if (slidewave::dem::at_work() && comm == MPI_COMM_WORLD) {
    slidewave::dem::ends_here->fail(
        "a VTK dump in the LIGGGHTS script would wait for the fluid for ever: remove it, particles "
        "are written to dem/particles.vtk.series anyway",
        2);
  }
  return PMPI_Comm_dup(comm, copy);
}
}
