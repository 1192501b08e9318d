// LIGGGHTS ends itself on an error: MPI_Finalize and exit, or MPI_Abort of its communicator. The
// first leaves the fluid waiting for ever. The executable therefore brings its own MPI_Finalize,
// MPI_Abort and MPI_Comm_dup: called while LIGGGHTS is at work, they mean an error (the last one a
// VTK dump about to wait for the fluid) and lead to Session::fail with LIGGGHTS' own words.
#pragma once

#include <filesystem>

#include "slidewave/coupler.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::dem {

/// From now on errors go to `session`; `log` is where LIGGGHTS' screen output ends up.
void route_errors(Session const& session, std::filesystem::path log);
/// Lets messages quote the script line; nullptr when the instance is gone.
void quote_script_of(LAMMPS_NS::LAMMPS* lmp);

/// While one lives, LIGGGHTS is at work.
class InsideLiggghts {
 public:
  InsideLiggghts();
  ~InsideLiggghts();
  InsideLiggghts(InsideLiggghts const&) = delete;
};

}  // namespace slidewave::dem
