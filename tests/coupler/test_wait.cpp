#include <gtest/gtest.h>

#include <thread>

#include "two_sides.hpp"

using namespace slidewave;

TEST(Profile, ScopesDoNotCountWhatWasWaitedInside) {
  Profile profile;
  {
    Scope const outer(profile, Phase::exchange);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    {
      Scope const inner(profile, Phase::locate);
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
  }
  EXPECT_NEAR(profile.of(Phase::locate), 0.03, 0.02);
  EXPECT_NEAR(profile.of(Phase::exchange), 0.02, 0.02);
  EXPECT_LT(profile.of(Phase::exchange), profile.of(Phase::locate) + 0.01);
}

TEST(Waiter, CountsTheWaitAndReturns) {
  TwoSides sides;
  double const start = now_s();
  sides.session.waiter.until([start] { return now_s() - start > 0.05; },
                             [] { return std::string("the clock"); });
  EXPECT_GE(now_s() - start, 0.05);
  EXPECT_NEAR(sides.session.profile.of(Phase::wait), now_s() - start, 0.05);
}

TEST(Waiter, AReadyThingCostsNothing) {
  TwoSides sides;
  double const before = sides.session.profile.of(Phase::wait);
  sides.session.waiter.until([] { return true; }, [] { return std::string("nothing"); });
  EXPECT_EQ(sides.session.profile.of(Phase::wait), before);
}
