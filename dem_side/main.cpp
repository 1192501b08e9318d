// slidewave_dem DIR: the particles of the run prepared in DIR (see docs/case_format.md).
// slidewave_dem --script FILE [-var NAME VALUE ...]: a plain LIGGGHTS run.
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "liggghts_engine.h"
#include "script_run.h"
#include "slidewave/coupler.hpp"

namespace {

int couple(slidewave::Session& session) {
  slidewave::dem::LiggghtsEngine engine(session);
  return slidewave::run(session, engine);
}

}  // namespace

int main(int argument_count, char** arguments) {
  bool const script = argument_count > 2 && std::strcmp(arguments[1], "--script") == 0;
  if (script) {
    return slidewave::dem::run_script(argument_count, arguments);
  }
  if (argument_count != 2 || arguments[1][0] == '-') {
    std::fprintf(stderr,
                 "usage: slidewave_dem DIR | slidewave_dem --script FILE [-var NAME VALUE ...]\n");
    return 2;
  }
  // Absolute: the engine changes the working directory.
  slidewave::Session session(slidewave::Role::dem, std::filesystem::absolute(arguments[1]));
  return slidewave::guarded(session, couple);
}
