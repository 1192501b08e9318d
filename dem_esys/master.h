// The master of ESyS-Particle: runs the case's Python script, which leaves a simulation `sim`, and
// then its time steps.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "slidewave/scene.hpp"

namespace slidewave::esys {

class Master {
 public:
  /// Runs `script` with the values of `parameters` as v_NAME. Throws InputError where it fails,
  /// leaves no `sim`, or has run time steps.
  Master(std::filesystem::path const& script, std::map<std::string, std::string> const& parameters);

  /// `steps` time steps of `dt_s`.
  void run(long steps, double dt_s);
};

}  // namespace slidewave::esys
