// history.csv: a row a window. The header comes from the first row; later rows must match it.
#pragma once

#include <cstdio>
#include <filesystem>
#include <vector>

#include "slidewave/engine.hpp"

namespace slidewave {

class History {
 public:
  explicit History(std::filesystem::path const& file);
  ~History();
  History(History const&) = delete;
  /// Throws std::runtime_error where the columns change or the disk is full.
  void add(Window const& window, std::vector<Quantity> const& columns);

 private:
  std::FILE* file_;
  std::vector<std::string> names_;
};

}  // namespace slidewave
