// Where an engine's own words go: the terminal belongs to slidewave.
#pragma once

#include <filesystem>

#include "slidewave/coupler.hpp"

namespace slidewave {

/// From here on all that this process prints is appended to `log` (in the run directory), line by
/// line, by all ranks of the session. Emptied at first, unless the run directory holds checkpoints,
/// so that a run that goes on keeps what was told. Collective; throws std::runtime_error.
void send_screen_to(std::filesystem::path const& log, Session const& session);

}  // namespace slidewave
