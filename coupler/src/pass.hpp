// How the coupler's own values go through a checkpoint.
#pragma once

#include <map>

#include "slidewave/engine.hpp"
#include "slidewave/state.hpp"
#include "sums.hpp"

namespace slidewave {

/// Without the seconds: time spent is no state.
template <class Sums>
void pass_sums(State& state, std::string const& name, Sums& sums) {
  state.pass(name, numbers_of(sums), count_of<Sums>() - 2 * Profile::phases);
}

inline void pass_columns(State& state, std::string const& name, std::vector<Quantity>& columns) {
  std::vector<std::string> names;
  std::vector<double> values;
  for (Quantity const& column : columns) {
    names.push_back(column.name);
    values.push_back(column.value);
  }
  state.pass(name + ".names", names);
  state.pass(name + ".values", values);
  columns.resize(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    columns[k] = {names[k], values[k]};
  }
}

inline void pass_map(State& state, std::string const& name, std::map<std::string, double>& map) {
  std::vector<Quantity> entries;
  entries.reserve(map.size());
  for (auto const& [key, value] : map) {
    entries.push_back({key, value});
  }
  pass_columns(state, name, entries);
  for (Quantity const& entry : entries) {
    map[entry.name] = entry.value;
  }
}

}  // namespace slidewave
