// The resolved case: DIR/case.toml as both executables read it.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "slidewave/table.hpp"

namespace slidewave {

/// What a user can mend: file, key, value and the remedy. Ends a run with exit status 2.
class InputError : public std::runtime_error {
 public:
  InputError(std::string const& file, std::string const& key, std::string const& value,
             std::string const& remedy);
};

class Scene {
 public:
  /// Reads `run_directory`/case.toml. Throws InputError where it is missing or malformed.
  explicit Scene(std::filesystem::path const& run_directory);
  ~Scene();
  Scene(Scene&&) noexcept;

  std::filesystem::path const& directory() const;
  /// Dotted keys, e.g. "coupling.window". The first form throws InputError where the key is missing
  /// or of another type; the second gives `otherwise` where it is missing.
  double number(std::string const& key) const;
  double number(std::string const& key, double otherwise) const;
  std::string text(std::string const& key) const;
  std::string text(std::string const& key, std::string const& otherwise) const;
  bool flag(std::string const& key, bool otherwise) const;
  Vec3 vector(std::string const& key) const;
  /// A list of one finite number or more.
  std::vector<double> numbers(std::string const& key) const;
  bool has(std::string const& key) const;
  /// Names of the tables (or keys) directly below a dotted key, in file order.
  std::vector<std::string> keys(std::string const& table) const;
  /// FNV-1a of the resolved text; both sides compare it in the handshake.
  std::string fingerprint() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace slidewave
