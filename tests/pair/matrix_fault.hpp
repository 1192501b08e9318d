// The faults of fault_matrix.py: parameters.fault = "matrix KIND SIDE PLACE" strikes once, in
// window 15, on one rank of a side, before, in or after an exchange: in the engine's calls around
// it.
#pragma once

#include <sys/resource.h>

#include "fault.hpp"

class MatrixFault {
 public:
  MatrixFault(slidewave::Session const& session, std::string side)
      : session_(session), side_(std::move(side)) {}

  /// Whether a fault that the engine itself has to show is due here.
  bool is(std::string const& kind, std::string const& place, long window) const {
    int const rank = kind == "layout" ? 0 : session_.size() - 1;  // the first one sends columns
    return window == 15 && session_.rank() == rank &&
           fault(session_, "matrix " + kind + " " + side_ + " " + place);
  }

  /// The faults that need nothing of the engine.
  void strike(std::string const& place, long window) const {
    if (is("exception", place, window)) {
      throw std::runtime_error("the " + side_ + " engine broke on purpose");
    }
    if (is("exit", place, window)) {
      std::exit(0);
    }
    if (is("segfault", place, window)) {
      std::raise(SIGSEGV);
    }
    if (is("kill", place, window)) {
      kill(getpid(), SIGKILL);
    }
    if (is("stall", place, window)) {
      sleep(60);
    }
    if (is("disk", place, window)) {  // no file may grow any more, as on a full disk
      rlimit const nothing{1, 1};
      std::signal(SIGXFSZ, SIG_IGN);
      setrlimit(RLIMIT_FSIZE, &nothing);
    }
  }

 private:
  slidewave::Session const& session_;
  std::string side_;
};
