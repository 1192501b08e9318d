// The user's terminal: duplicates of stdout and stderr taken before an engine redirects them.
#pragma once

#include <string>

namespace slidewave {

class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(Terminal const&) = delete;

  /// One line, written at once so that lines of several ranks never mix.
  void say(std::string const& line) const;
  void complain(std::string const& line) const;

 private:
  int out_;
  int err_;
};

}  // namespace slidewave
