#include "script_run.h"

#include <mpi.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "input.h"
#include "lammps.h"
#include "registry.h"

namespace slidewave::dem {

int run_script(int argument_count, char** arguments) {
  if (!std::filesystem::is_regular_file(arguments[2])) {
    std::fprintf(stderr, "slidewave_dem: no script %s\n", arguments[2]);
    return 2;
  }
  MPI_Init(&argument_count, &arguments);
  std::string in_switch = "-in";
  std::vector<char*> words = {arguments[0], in_switch.data(), arguments[2]};
  words.insert(words.end(), arguments + 3, arguments + argument_count);
  {
    auto const lmp = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(words.size()),
                                                         words.data(), MPI_COMM_WORLD);
    register_styles(*lmp);
    lmp->input->file();
  }
  MPI_Finalize();
  return 0;
}

}  // namespace slidewave::dem
