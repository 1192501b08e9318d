#include "durable.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace slidewave {

void sync_directory(std::filesystem::path const& directory) {
  int const handle = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle >= 0) {  // some file systems know no such thing: then there is nothing to wait for
    ::fsync(handle);
    ::close(handle);
  }
}

void write_at_once(std::filesystem::path const& file, std::string const& text) {
  std::filesystem::path const beside = file.string() + ".part";
  int const handle = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  bool good = handle >= 0;
  for (std::size_t done = 0; good && done < text.size();) {
    ssize_t const count = ::write(handle, text.data() + done, text.size() - done);
    good = count > 0;
    done += good ? static_cast<std::size_t>(count) : 0;
  }
  good = good && ::fsync(handle) == 0;
  int const reason = errno;
  if (handle >= 0) {
    ::close(handle);
  }
  if (!good || std::rename(beside.c_str(), file.c_str()) != 0) {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", file.string(), std::strerror(good ? errno : reason)));
  }
  sync_directory(file.parent_path());
}

}  // namespace slidewave
