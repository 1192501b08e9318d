// Reads a LIGGGHTS script, includes too, for what must not run in a coupled run. The dumps that go
// through VTK talk to all processes of MPI_COMM_WORLD, the fluid's too, which never answer.
#pragma once

#include <filesystem>
#include <string>

namespace slidewave::dem {

struct ForbiddenCommand {
  std::filesystem::path file;
  int line = 0;
  std::string command;  ///< "dump custom/vtk", or "clear"; empty: nothing found
};

/// The first forbidden command in `script` (`folder` is where includes are looked up).
ForbiddenCommand find_forbidden(std::filesystem::path const& script,
                                std::filesystem::path const& folder);

}  // namespace slidewave::dem
