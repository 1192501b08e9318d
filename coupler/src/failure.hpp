// The one way out for every error: print the reason, record it, end both programs.
#pragma once

#include <filesystem>
#include <string>

#include "terminal.hpp"

namespace slidewave {

class Failure {
 public:
  /// Also watches for an engine that leaves by exit(): that would keep the partner waiting.
  Failure(std::filesystem::path directory, std::string who);
  ~Failure();
  Failure(Failure const&) = delete;

  /// The reason appears once on the terminal and in DIR/failure.txt, whichever rank comes first;
  /// then MPI_Abort of the true world with `status`.
  [[noreturn]] void fail(std::string const& reason, int status) const;
  /// Another process has recorded its failure: MPI_Abort is on its way, or stuck.
  bool another_failed() const;
  /// As `rank` becomes known; `who` is e.g. "dem rank 2 of 3".
  void rename(std::string who) { who_ = std::move(who); }
  std::string const& who() const { return who_; }
  Terminal const& terminal() const { return terminal_; }
  /// After a clean end exit() is no failure any more.
  void stand_down();
  /// Removes what an earlier run in this directory left.
  void forget_earlier() const;

 private:
  std::filesystem::path directory_;
  std::string who_;
  Terminal terminal_;
};

}  // namespace slidewave
