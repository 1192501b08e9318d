// "Did you mean": the name of a list that is fewest edits away from what was typed.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace slidewave {

/// Edits (insert, delete, replace a letter) from one word to another.
inline int edit_distance(std::string const& from, std::string const& to) {
  std::vector<int> row(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) {
    row[j] = int(j);
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    int diagonal = row[0];
    row[0] = int(i) + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      int const replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// The closest of `names`, or "" where none is within a third of its length (at least 2 edits).
inline std::string nearest_name(std::string const& typed, std::vector<std::string> const& names) {
  std::string nearest;
  int fewest = std::max(2, int(typed.size()) / 3) + 1;
  for (auto const& name : names) {
    int const edits = edit_distance(typed, name);
    if (edits < fewest) {
      fewest = edits;
      nearest = name;
    }
  }
  return nearest;
}

/// `"x" is not a WHAT; did you mean "y"? Known: a, b, c`
inline std::string unknown_name(std::string const& what, std::string const& typed,
                                std::vector<std::string> const& names) {
  std::string message = "\"" + typed + "\" is not a " + what;
  std::string const nearest = nearest_name(typed, names);
  message += nearest.empty() ? "; known:" : "; did you mean \"" + nearest + "\"? Known:";
  for (std::size_t i = 0; i < names.size(); ++i) {
    message += (i == 0 ? " " : ", ") + names[i];
  }
  return message;
}

}  // namespace slidewave
