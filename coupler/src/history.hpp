// history.csv: a row a window. The header comes from the first row; later rows must match it.
#pragma once

#include <cstdio>
#include <filesystem>
#include <vector>

#include "slidewave/engine.hpp"
#include "slidewave/state.hpp"

namespace slidewave {

class History {
 public:
  /// Begins a new file, or where `goes_on` keeps what is there for cut().
  explicit History(std::filesystem::path const& file, bool goes_on = false);
  ~History();
  History(History const&) = delete;
  /// Throws std::runtime_error where the columns change or the disk is full.
  void add(Window const& window, std::vector<Quantity> const& columns);
  /// Length of the file so far, all of it on disk.
  long bytes();
  /// Drops what was written after a checkpoint that has pass()ed.
  void pass(State& state);

 private:
  std::FILE* file_;
  std::vector<std::string> names_;
};

}  // namespace slidewave
