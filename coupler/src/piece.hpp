// One rank's file of a checkpoint: named blocks of bytes, each padded to whole words.
//
//   "slidewve" | name bytes, value bytes (64 bit each) | name, padded | values, padded | ...
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace slidewave {

/// 64-bit FNV-1a (Fowler, Noll, Vo), taken word by word: any changed word changes it.
class Checksum {
 public:
  void add(void const* words, long bytes);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

class PieceWriter {
 public:
  explicit PieceWriter(std::filesystem::path file);
  ~PieceWriter();
  PieceWriter(PieceWriter const&) = delete;
  void put(std::string const& name, void const* values, long bytes);
  /// Flushes to the disk itself.
  void finish();
  long bytes() const { return bytes_; }
  std::uint64_t checksum() const { return checksum_.value(); }

 private:
  void write(void const* data, long bytes);
  [[noreturn]] void give_up() const;

  std::filesystem::path path_;
  std::FILE* file_;
  std::vector<char> padded_;
  std::map<std::string, bool> names_;
  Checksum checksum_;
  long bytes_ = 0;
};

class PieceReader {
 public:
  /// Reads the names only. Throws std::runtime_error where the file is no whole piece.
  explicit PieceReader(std::filesystem::path file);
  ~PieceReader();
  PieceReader(PieceReader&& other) noexcept;
  bool has(std::string const& name) const { return blocks_.count(name) > 0; }
  long bytes_of(std::string const& name) const;
  void get(std::string const& name, void* values) const;

  /// Checksum of a whole file, to be compared with what its writer noted.
  static std::uint64_t checksum(std::filesystem::path const& file);

 private:
  struct Block {
    long offset, bytes;
  };
  std::filesystem::path path_;
  std::FILE* file_;
  std::map<std::string, Block> blocks_;
};

}  // namespace slidewave
