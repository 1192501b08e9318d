// Checks of what a script gives a contact model. LIGGGHTS does not tell a keyword left out from one
// given: what must be given starts as `not_given`.
#pragma once

#include <cmath>
#include <string>

#include "error.h"

namespace slidewave::dem {

constexpr double not_given = -1e300;

inline void need(LAMMPS_NS::Error& error, bool good, std::string const& model,
                 std::string const& keyword, double value, std::string const& wanted) {
  if (good) {
    return;
  }
  std::string const given = value == not_given ? "is missing" : "is " + std::to_string(value);
  std::string const text =
      "contact model " + model + ": " + keyword + " " + given + ", give " + wanted;
  error.all(FLERR, text.c_str());
}

inline void need_positive(LAMMPS_NS::Error& error, std::string const& model,
                          std::string const& keyword, double value, std::string const& unit) {
  need(error, value > 0 && std::isfinite(value), model, keyword, value,
       "a positive number " + unit);
}

inline void need_not_negative(LAMMPS_NS::Error& error, std::string const& model,
                              std::string const& keyword, double value, std::string const& unit) {
  need(error, value >= 0 && std::isfinite(value), model, keyword, value,
       "a number that is not negative " + unit);
}

}  // namespace slidewave::dem
