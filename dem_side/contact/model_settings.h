// Checks of what a script gives a contact model. LIGGGHTS does not tell a keyword left out from one
// given: what must be given starts as `not_given`.
#pragma once

#include <cmath>
#include <cstdlib>
#include <set>
#include <string>

#include "error.h"

namespace slidewave::dem {

constexpr double not_given = -1e300;

/// Refuses what LIGGGHTS would take in silence: a constant that is no number (0 to it), a keyword
/// given twice (the last one counts), a keyword at the end without a value. It refuses unknown ones
/// itself.
inline void check_words(LAMMPS_NS::Error& error, int count, char const* const* words) {
  static std::set<std::string> const numbers = {"kn",    "damping",  "ks", "mu", "damping_s",
                                                "shape", "crushing", "kr", "eta"};
  static std::set<std::string> const switches = {"attraction", "twist"};
  std::set<std::string> seen;
  for (int k = 0; k < count; k += 2) {
    std::string const keyword = words[k];
    bool const number = numbers.count(keyword) > 0;
    if (!number && switches.count(keyword) == 0) {
      return;
    }
    std::string fault;
    char* end = nullptr;
    if (k + 1 == count) {
      fault = " has no value, give one";
    } else if (!seen.insert(keyword).second) {
      fault = " is given twice, give it once";
    } else if (number && (std::strtod(words[k + 1], &end), end == words[k + 1] || *end)) {
      fault = std::string(" is '") + words[k + 1] + "', give a number";
    }
    if (!fault.empty()) {
      fault.insert(0, "contact model: " + keyword);
      error.all(FLERR, fault.c_str());
    }
  }
}

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
