// slidewave_lammps DIR: the particles of the run prepared in DIR, with LAMMPS
// (docs/case_format.md).
#include <cstdio>
#include <filesystem>

#include "lammps_engine.h"
#include "slidewave/coupler.hpp"

namespace {

int couple(slidewave::Session& session) {
  slidewave::lammps::LammpsEngine engine(session);
  return slidewave::run(session, engine);
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2 || arguments[1][0] == '-') {
    std::fputs("usage: slidewave_lammps DIR   (one mpirun starts both sides)\n", stderr);
    return 2;
  }
  // Absolute: the engine changes the working directory.
  slidewave::Session session(slidewave::Role::dem, std::filesystem::absolute(arguments[1]));
  return slidewave::guarded(session, couple);
}
