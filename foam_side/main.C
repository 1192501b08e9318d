// slidewave_foam DIR: the fluid side of a coupled run.
#include <cstdio>
#include <iostream>
#include <memory>

#include "FoamEngine.H"
#include "World.H"
#include "error.H"
#include "slidewave/coupler.hpp"

namespace {

using namespace slidewave;

// OpenFOAM writes to stdout; the user's terminal belongs to Session::say. A run that may go on from
// a checkpoint keeps what the log holds.
void sendOutputTo(std::filesystem::path const& log, MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  bool const goes_on = std::filesystem::exists(log.parent_path() / "checkpoints");
  if (rank == 0) std::freopen(log.c_str(), goes_on ? "a" : "w", stdout);
  MPI_Barrier(comm);
  if (rank != 0) std::freopen(log.c_str(), "a", stdout);
}

// A case that OpenFOAM cannot open is bad input (2); what happens later is a failed run (1).
std::unique_ptr<foam::FoamEngine> open(Session& session) {
  try {
    return std::make_unique<foam::FoamEngine>(session.scene(), session.comm());
  } catch (Foam::error const& problem) {
    Foam::Info << problem << Foam::endl;
    session.fail("OpenFOAM: " + problem.message(), 2);
  }
}

int simulate(Session& session) {
  sendOutputTo(session.scene().directory() / "log.fluid", session.comm());
  foam::enterWorld(session.comm(), [&session](std::string const& reason, int status) {
    session.fail(reason, status);
  });
  std::unique_ptr<foam::FoamEngine> const engine = open(session);
  for (auto const& [name, value] : engine->facts()) session.state(name, value);
  return run(session, *engine);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: slidewave_foam DIR   (a run directory; one mpirun starts both sides)\n";
    return 2;
  }
  Session session(Role::fluid, argv[1]);
  return guarded(session, simulate);
}
