#include "failure.hpp"

#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace slidewave {
namespace {

Failure const* watched = nullptr;

void on_exit_before_the_end() {
  if (watched) {
    watched->fail("the program called exit() before the run was over", 1);
  }
}

void pause_ms(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

}  // namespace

Failure::Failure(std::filesystem::path directory, std::string who)
    : directory_(std::move(directory)), who_(std::move(who)) {
  static bool const registered = std::atexit(on_exit_before_the_end) == 0;
  (void)registered;
  watched = this;
}

Failure::~Failure() {
  stand_down();
}

void Failure::stand_down() {
  watched = nullptr;
}

void Failure::forget_earlier() const {
  std::error_code ignored;
  std::filesystem::remove(directory_ / "failure.txt", ignored);
}

bool Failure::another_failed() const {
  std::error_code ignored;
  return std::filesystem::exists(directory_ / "failure.txt", ignored);
}

void Failure::fail(std::string const& reason, int status) const {
  watched = nullptr;
  std::fflush(nullptr);
  std::string const text = "slidewave: " + who_ + ": " + reason;
  // Creating the record decides which rank speaks: an error that all ranks meet is printed once.
  int const record =
      ::open((directory_ / "failure.txt").c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  bool const another_spoke = record < 0 && errno == EEXIST;
  if (record >= 0) {
    std::string const line = text + "\n";
    (void)!::write(record, line.data(), line.size());
    ::close(record);
  }
  if (!another_spoke) {
    terminal_.complain(text);
  }
  pause_ms(another_spoke ? 500 : 100);  // lets the launcher forward the line
  int initialised = 0;
  int finalised = 0;
  MPI_Initialized(&initialised);
  MPI_Finalized(&finalised);
  if (initialised && !finalised) {
    // An abort that gets stuck is not to keep anybody waiting: dying of a signal ends the job too.
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(3);
    PMPI_Abort(MPI_COMM_WORLD, status);
  }
  std::_Exit(status);
}

}  // namespace slidewave
