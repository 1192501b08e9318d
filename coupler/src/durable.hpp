// Files that survive a crash right after they are written.
#pragma once

#include <filesystem>
#include <string>

namespace slidewave {

/// Makes names in a directory last: files created, renamed or removed in it.
void sync_directory(std::filesystem::path const& directory);

/// Writes `text` beside `file` and renames it into place once it is on disk: the file is there
/// whole, or not at all. Throws std::runtime_error where that fails.
void write_at_once(std::filesystem::path const& file, std::string const& text);

}  // namespace slidewave
