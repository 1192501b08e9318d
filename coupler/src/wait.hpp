// Waiting without a hang: test, back off up to 200 us (ranks of both sides share cores), speak
// every 30 s, give up after the patience.
#pragma once

#include <mpi.h>

#include <string>

#include "failure.hpp"
#include "profile.hpp"

namespace slidewave {

class Waiter {
 public:
  Waiter(Failure const& failure, Profile& profile, double patience_s)
      : failure_(failure), profile_(profile), patience_s_(patience_s) {}

  /// This rank prints the reminders: one rank a side does.
  void speaks(bool speaks) { speaks_ = speaks; }
  void patience(double seconds) { patience_s_ = seconds; }
  /// While programs join, the limit is not the user's.
  void joining(bool joining) { joining_ = joining; }
  double patience() const { return patience_s_; }

  /// Tests until `done()`; `awaited()` tells what is missing, e.g. "fluid: answers of window 12".
  template <class Done, class Awaited>
  void until(Done&& done, Awaited&& awaited, Phase counted_as = Phase::wait) {
    if (done()) {
      return;
    }
    Attempt attempt;
    while (!done()) {
      if (attempt.back_off() && must_speak(attempt)) {  // texts are made only to be said
        remind(attempt, awaited());
      }
    }
    profile_.add(counted_as, now_s() - attempt.start_s, processor_s() - attempt.start_busy_s);
  }

  template <class Awaited>
  void request(MPI_Request& request, Awaited&& awaited) {
    until(
        [&] {
          int done = 0;
          MPI_Test(&request, &done, MPI_STATUS_IGNORE);
          return done != 0;
        },
        awaited);
  }

 private:
  struct Attempt {
    double start_s = now_s();
    double start_busy_s = processor_s();
    double spoken_s = start_s;
    double checked_s = start_s;
    double watched_s = start_s;
    long tries = 0;
    /// Sleeps a little; true about ten times a second, when the clock should be looked at.
    bool back_off();
  };
  /// Ends this rank where another one failed; true where the wait is long enough for words.
  bool must_speak(Attempt& attempt) const;
  void remind(Attempt& attempt, std::string const& awaited) const;

  Failure const& failure_;
  Profile& profile_;
  double patience_s_;
  bool speaks_ = false;
  bool joining_ = false;
};

}  // namespace slidewave
