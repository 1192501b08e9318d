// Counts what this process allocates from one window to another, engines left out: the fakes pause
// the count in each of their calls. new is counted whatever its size, malloc (Eigen's; MPI's too)
// from 1 kB. Each rank appends a line to DIR/allocations.txt:  side rank times largest_bytes
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "slidewave/coupler.hpp"

extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_realloc(void* old, std::size_t size);

namespace counted {

constexpr long first_window = 8, last_window = 18;
constexpr std::size_t least_malloc = 1024;

inline bool running = false;
inline int paused = 0;
inline long times = 0;
inline std::size_t largest = 0;

inline void note(std::size_t size) {
  if (running && paused == 0) {
    ++times;
    largest = size > largest ? size : largest;
  }
}

/// An engine's call: what it allocates is its own affair.
struct Pause {
  Pause() { ++paused; }
  ~Pause() { --paused; }
};

inline void window_begins(slidewave::Session const& session, char const* side, long window) {
  running = window >= first_window && window < last_window;
  if (window != last_window) {
    return;
  }
  std::FILE* const file =
      std::fopen((session.scene().directory() / "allocations.txt").c_str(), "a");
  std::fprintf(file, "%s %d %ld %zu\n", side, session.rank(), times, largest);
  std::fclose(file);
}

}  // namespace counted

extern "C" void* malloc(std::size_t size) {
  if (size >= counted::least_malloc) {
    counted::note(size);
  }
  return __libc_malloc(size);
}

extern "C" void* realloc(void* old, std::size_t size) {
  if (size >= counted::least_malloc) {
    counted::note(size);
  }
  return __libc_realloc(old, size);
}

void* operator new(std::size_t size) {
  counted::note(size);
  if (void* const place = __libc_malloc(size)) {
    return place;
  }
  throw std::bad_alloc();
}

void operator delete(void* place) noexcept {
  std::free(place);
}

void operator delete(void* place, std::size_t) noexcept {
  std::free(place);
}
