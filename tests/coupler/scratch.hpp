// A run directory for a test, with a case.toml.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

struct Scratch {
  std::filesystem::path path;
  /// `shared`: the same name on all ranks, else one a process.
  explicit Scratch(std::string const& text, std::string const& shared = "")
      : path(std::filesystem::temp_directory_path() /
             ("slidewave_test_" + (shared.empty() ? std::to_string(::getpid()) : shared))) {
    std::filesystem::create_directories(path);
    std::string const temporary = path / ("case.toml." + std::to_string(::getpid()));
    std::ofstream(temporary) << text;
    std::filesystem::rename(temporary, path / "case.toml");
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};
