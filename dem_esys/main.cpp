// slidewave_esys DIR: the particles of the run prepared in DIR, with ESyS-Particle
// (docs/case_format.md).
#include <cstdio>
#include <filesystem>

#include "esys_engine.h"
#include "slidewave/coupler.hpp"

namespace {

int couple(slidewave::Session& session) {
  slidewave::esys::EsysEngine engine(session);
  return slidewave::run(session, engine);
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2 || arguments[1][0] == '-') {
    std::fputs("usage: slidewave_esys DIR   (one mpirun starts both sides)\n", stderr);
    return 2;
  }
  // Absolute: the engine changes the working directory.
  slidewave::Session session(slidewave::Role::dem, std::filesystem::absolute(arguments[1]));
  return slidewave::guarded(session, couple);
}
