// The fixed set of message tags on the intercommunicator. Order of messages is carried by a header.
#pragma once

namespace slidewave::tag {

constexpr int text = 1;
constexpr int particles = 2;  ///< dem -> fluid: the particles of a window, to their likely owners
constexpr int misses = 3;     ///< fluid -> dem: which of them the rank does not own
constexpr int queries = 4;    ///< dem -> fluid: how far are these points from you
constexpr int distances = 5;  ///< fluid -> dem
constexpr int moves = 6;      ///< dem -> fluid: decisions about missed particles
constexpr int answers = 7;    ///< fluid -> dem: drag, velocity, force
constexpr int row = 8;        ///< root to root: the row for history.csv

}  // namespace slidewave::tag
