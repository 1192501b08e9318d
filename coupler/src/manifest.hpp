// What makes a set of files a checkpoint. It is written last, in one step: without it the files
// beside it are remains of a run that did not come to finish them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "profile.hpp"
#include "slidewave/state.hpp"

namespace slidewave {

/// Wall time spent before the checkpoint, and in how many runs: not part of the state, so that
/// equal states are equal files.
struct Spent {
  double wall_s = 0;
  long restarts = 0;
  double fluid_s[Profile::phases] = {};  ///< sums over the ranks of the side
  double dem_s[Profile::phases] = {};
};

struct Manifest {
  long window = 0;
  double time_s = 0;
  double window_s = 0;  ///< coupling.window
  std::string version;
  std::string fingerprint;  ///< of case.toml
  int fluid_ranks = 0, dem_ranks = 0;
  long history_bytes = 0;
  Spent spent;
  std::vector<State::Written> pieces;  ///< fluid ranks first

  static std::string piece_name(bool fluid, int rank);
  /// DIR/checkpoints, and the place of a window in it.
  static std::filesystem::path folder(std::filesystem::path const& run_directory);
  static std::filesystem::path folder(std::filesystem::path const& run_directory, long window);
  static std::filesystem::path file(std::filesystem::path const& run_directory, long window) {
    return folder(run_directory, window) / "manifest.json";
  }
  /// Windows that have a manifest, the newest first.
  static std::vector<long> windows(std::filesystem::path const& run_directory);

  /// Throws std::runtime_error with the reason where it is no manifest.
  static Manifest read(std::filesystem::path const& run_directory, long window);
  void write(std::filesystem::path const& run_directory) const;
  /// Why its files cannot be what was written, looking at names and sizes; empty where they can.
  std::string fault(std::filesystem::path const& run_directory) const;
  State::Written const& piece(bool fluid, int rank) const {
    return pieces[static_cast<std::size_t>(fluid ? rank : fluid_ranks + rank)];
  }
};

}  // namespace slidewave
