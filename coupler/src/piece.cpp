#include "piece.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace slidewave {
namespace {

constexpr char magic[] = "slidewve";  // a word long
constexpr long word = 8;

long padded(long bytes) {
  return (bytes + word - 1) / word * word;
}

}  // namespace

void Checksum::add(void const* words, long bytes) {
  auto const* at = static_cast<char const*>(words);
  for (long k = 0; k < bytes; k += word) {
    std::uint64_t next;
    std::memcpy(&next, at + k, sizeof(next));
    value_ = (value_ ^ next) * 1099511628211ULL;
  }
}

PieceWriter::PieceWriter(std::filesystem::path file)
    : path_(std::move(file)), file_(std::fopen(path_.c_str(), "wbx")) {
  if (!file_) {
    give_up();
  }
  write(magic, word);
}

PieceWriter::~PieceWriter() {
  if (file_) {
    std::fclose(file_);
  }
}

void PieceWriter::give_up() const {
  throw std::runtime_error(
      fmt::format("cannot write the checkpoint {}: {}", path_.string(), std::strerror(errno)));
}

void PieceWriter::write(void const* data, long bytes) {
  void const* words = data;
  if (bytes % word != 0) {
    padded_.assign(static_cast<std::size_t>(padded(bytes)), 0);
    std::memcpy(padded_.data(), data, static_cast<std::size_t>(bytes));
    words = padded_.data();
    bytes = padded(bytes);
  }
  if (bytes > 0 && std::fwrite(words, 1, static_cast<std::size_t>(bytes), file_) !=
                       static_cast<std::size_t>(bytes)) {
    give_up();
  }
  checksum_.add(words, bytes);
  bytes_ += bytes;
}

void PieceWriter::put(std::string const& name, void const* values, long bytes) {
  if (!names_.emplace(name, true).second) {
    throw std::logic_error("a checkpoint has two blocks named " + name);
  }
  std::uint64_t const sizes[2] = {name.size(), static_cast<std::uint64_t>(bytes)};
  write(sizes, sizeof(sizes));
  write(name.data(), static_cast<long>(name.size()));
  write(values, bytes);
}

void PieceWriter::finish() {
  bool const failed = std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0;
  if (failed || std::fclose(std::exchange(file_, nullptr)) != 0) {
    give_up();
  }
}

PieceReader::PieceReader(std::filesystem::path file)
    : path_(std::move(file)), file_(std::fopen(path_.c_str(), "rb")) {
  auto const refuse = [&] { throw std::runtime_error(path_.string() + " is no whole checkpoint"); };
  if (!file_) {
    throw std::runtime_error(
        fmt::format("cannot read {}: {}", path_.string(), std::strerror(errno)));
  }
  long const whole = static_cast<long>(std::filesystem::file_size(path_));
  char begin[word];
  if (std::fread(begin, 1, word, file_) != word || std::memcmp(begin, magic, word) != 0) {
    refuse();
  }
  std::uint64_t sizes[2];
  while (std::fread(sizes, sizeof(sizes), 1, file_) == 1) {
    if (sizes[0] > static_cast<std::uint64_t>(whole)) {
      refuse();
    }
    std::string name(static_cast<std::size_t>(padded(static_cast<long>(sizes[0]))), '\0');
    if (!name.empty() && std::fread(name.data(), name.size(), 1, file_) != 1) {
      refuse();
    }
    name.resize(sizes[0]);
    Block const block{std::ftell(file_), static_cast<long>(sizes[1])};
    if (block.bytes < 0 || block.bytes > whole - block.offset ||
        std::fseek(file_, padded(block.bytes), SEEK_CUR) != 0) {
      refuse();
    }
    blocks_[name] = block;
  }
}

PieceReader::~PieceReader() {
  if (file_) {
    std::fclose(file_);
  }
}

PieceReader::PieceReader(PieceReader&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, nullptr)),
      blocks_(std::move(other.blocks_)) {}

long PieceReader::bytes_of(std::string const& name) const {
  auto const found = blocks_.find(name);
  if (found == blocks_.end()) {
    throw std::runtime_error(path_.string() + " holds no '" + name +
                             "': another scene or version wrote it");
  }
  return found->second.bytes;
}

void PieceReader::get(std::string const& name, void* values) const {
  auto const bytes = static_cast<std::size_t>(bytes_of(name));
  if (std::fseek(file_, blocks_.at(name).offset, SEEK_SET) != 0 ||
      std::fread(values, 1, bytes, file_) != bytes) {
    throw std::runtime_error("cannot read '" + name + "' in " + path_.string());
  }
}

std::uint64_t PieceReader::checksum(std::filesystem::path const& file) {
  Checksum sum;
  std::FILE* const in = std::fopen(file.c_str(), "rb");
  std::vector<char> buffer(1 << 20);
  std::size_t count = 0;
  while (in && (count = std::fread(buffer.data(), 1, buffer.size(), in)) > 0) {
    sum.add(buffer.data(), static_cast<long>(count / word * word));
  }
  if (in) {
    std::fclose(in);
  }
  return sum.value();
}

}  // namespace slidewave
