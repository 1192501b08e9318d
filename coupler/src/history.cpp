#include "history.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace slidewave {

History::History(std::filesystem::path const& file, bool goes_on)
    : file_(std::fopen(file.c_str(), goes_on ? "r+" : "w")) {
  if (!file_) {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
  }
}

History::~History() {
  std::fclose(file_);
}

long History::bytes() {
  ::fsync(::fileno(file_));  // add() has flushed it
  return std::ftell(file_);
}

void History::pass(State& state) {
  long length = bytes();
  state.pass("history.names", names_);
  state.pass("history.bytes", length);
  if (!state.saving() &&
      (::ftruncate(::fileno(file_), length) != 0 || std::fseek(file_, length, SEEK_SET) != 0)) {
    throw std::runtime_error(fmt::format("cannot shorten history.csv: {}", std::strerror(errno)));
  }
}

void History::add(Window const& window, std::vector<Quantity> const& columns) {
  std::string line;
  if (names_.empty()) {
    line = "window,time_s";
    for (Quantity const& column : columns) {
      names_.push_back(column.name);
      line += "," + column.name;
    }
    line += "\n";
  }
  line += fmt::format("{},{:.10g}", window.index, window.t1_s);
  bool same = columns.size() == names_.size();
  for (std::size_t k = 0; same && k < columns.size(); ++k) {
    same = columns[k].name == names_[k];
    line += fmt::format(",{:.12g}", columns[k].value);
  }
  if (!same) {
    throw std::runtime_error("an engine changed the names of its quantities during the run");
  }
  line += "\n";
  if (std::fwrite(line.data(), 1, line.size(), file_) != line.size() || std::fflush(file_) != 0) {
    throw std::runtime_error(fmt::format("cannot write history.csv: {}", std::strerror(errno)));
  }
}

}  // namespace slidewave
