#include <gtest/gtest.h>

#include <thread>

#include "two_sides.hpp"

using namespace slidewave;

// Bounds that hold however late a sleeper is woken: each phase has its own sleep, and never more
// than the whole less the other's.
TEST(Profile, ScopesDoNotCountWhatWasWaitedInside) {
  Profile profile;
  double const start = now_s();
  {
    Scope const outer(profile, Phase::exchange);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    {
      Scope const inner(profile, Phase::locate);
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
  }
  double const whole = now_s() - start, clock = 1e-4;
  EXPECT_GE(profile.of(Phase::locate), 0.03 - clock);
  EXPECT_LE(profile.of(Phase::locate), whole - 0.02 + clock);
  EXPECT_GE(profile.of(Phase::exchange), 0.02 - clock);
  EXPECT_LE(profile.of(Phase::exchange), whole - 0.03 + clock);
}

TEST(Waiter, CountsTheWaitAndReturns) {
  TwoSides sides;
  double const before = sides.session.profile.of(Phase::wait);  // for the other side to join
  double const start = now_s();
  double first = 0, last = 0;  // asked
  sides.session.waiter.until(
      [&] {
        last = now_s();
        first = first > 0 ? first : last;
        return last - start > 0.05;
      },
      [] { return std::string("the clock"); });
  double const waited = sides.session.profile.of(Phase::wait) - before;
  EXPECT_GT(last - start, 0.05);
  EXPECT_GE(waited, last - first - 1e-4);
  EXPECT_LE(waited, now_s() - start + 1e-4);
}

TEST(Waiter, AReadyThingCostsNothing) {
  TwoSides sides;
  double const before = sides.session.profile.of(Phase::wait);
  sides.session.waiter.until([] { return true; }, [] { return std::string("nothing"); });
  EXPECT_EQ(sides.session.profile.of(Phase::wait), before);
}
