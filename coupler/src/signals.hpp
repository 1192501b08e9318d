// SIGTERM, SIGINT and SIGUSR1 ask for a clean end at the next window; a second one ends at once.
#pragma once

namespace slidewave {

void watch_signals();
bool stop_was_asked();

}  // namespace slidewave
