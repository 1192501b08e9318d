// Faults that tests inject through the case key parameters.fault, e.g. "drop_cell". The fakes call
// these; an engine of your own needs none of it.
#pragma once

#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "slidewave/coupler.hpp"

inline bool fault(slidewave::Session const& session, std::string const& name) {
  return session.scene().text("parameters.fault", "") == name;
}

/// Something that is to be left out in window 3, once.
inline bool dropped(slidewave::Session const& session, std::string const& name, long window,
                    bool here = true) {
  return here && window == 3 && fault(session, name);
}

/// A cell, or a whole rank, that a budget forgets.
inline bool forgotten(slidewave::Session const& session, long window, bool chosen_cell) {
  return dropped(session, "drop_cell", window, chosen_cell) ||
         dropped(session, "drop_rank", window, session.rank() == session.size() - 1);
}

inline char const* name_of_density(slidewave::Session const& session) {
  return fault(session, "no_density") ? "mass" : "density";
}

/// Ways in which an engine may break in the middle of a run; `side` is "fluid" or "dem".
inline void break_down(slidewave::Session const& session, std::string const& side, long window) {
  if (window == 20 && fault(session, side + "_signalled")) {
    kill(getpid(), SIGTERM);
  }
  if (window > 0 && fault(session, "slow")) {  // both sides
    usleep(200000);
  }
  if (window != 5) {
    return;
  }
  if (fault(session, side + "_throws") && session.rank() == session.size() - 1) {
    throw std::runtime_error("the " + side + " engine broke on purpose");
  }
  if (fault(session, side + "_exits")) {
    std::exit(0);
  }
  if (fault(session, side + "_vanishes")) {
    _exit(0);
  }
  if (fault(session, side + "_is_killed")) {
    kill(getpid(), SIGKILL);
  }
  if (fault(session, side + "_stalls")) {
    sleep(60);
  }
}

/// Ways in which particles may go wrong.
inline void spoil(slidewave::Session const& session, long window, Eigen::Matrix3Xd& x,
                  Eigen::Matrix3Xd& v) {
  if (window == 4 && fault(session, "dem_nan")) {
    v(1, 0) = NAN;
  }
  if (window == 4 && fault(session, "fall_out")) {
    x(2, 0) = -0.5;
  }
  if (window == 4 && fault(session, "touch_wall")) {
    x(1, 0) = -0.5 * session.scene().number("parameters.radius");
  }
}
