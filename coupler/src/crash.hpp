// A last word of a process that crashes: segmentation fault, abort, bus error, illegal instruction.
#pragma once

#include <filesystem>
#include <string>

namespace slidewave {

/// From now on such a signal records its name in `failure_file`, says it on stderr, and then ends
/// the process as it would have. `who`: "fluid rank 1 of 2".
void report_crashes(std::filesystem::path const& failure_file, std::string const& who);
/// Once more, after an engine may have taken the signals.
void report_crashes_again();

}  // namespace slidewave
