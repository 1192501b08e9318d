// LAMMPS ends itself on an error: Error::all calls MPI_Finalize and exit, Error::one MPI_Abort of
// its communicator. The first leaves the fluid waiting for ever. The executable therefore brings
// its own MPI_Finalize and MPI_Abort: called while LAMMPS is at work they mean an error, and lead
// to Session::fail with LAMMPS' own words.
#pragma once

#include <filesystem>

#include "slidewave/coupler.hpp"

namespace slidewave::lammps {

/// From now on errors go to `session`; `log` is where LAMMPS' screen output ends up.
void route_errors(Session const& session, std::filesystem::path log);

/// While one lives, LAMMPS is at work.
class InsideLammps {
 public:
  InsideLammps();
  ~InsideLammps();
  InsideLammps(InsideLammps const&) = delete;
};

}  // namespace slidewave::lammps
