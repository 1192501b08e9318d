#include <gtest/gtest.h>

#include "windows.hpp"

using namespace slidewave;

TEST(Windows, FirstHasNoLengthAndLastEndsExactly) {
  Windows const windows(0.1, 0.3);  // 3 x 0.1 is not 0.3 in binary
  EXPECT_EQ(windows.count(), 3);
  EXPECT_EQ(windows[0].length_s(), 0);
  EXPECT_EQ(windows[3].t1_s, 0.3);
}

TEST(Windows, ShortRemainderIsTheLastWindow) {
  Windows const windows(0.02, 0.05);
  EXPECT_EQ(windows.count(), 3);
  EXPECT_NEAR(windows[3].length_s(), 0.01, 1e-15);
}

TEST(Windows, TileTheRun) {
  Windows const windows(0.02, 50);
  EXPECT_EQ(windows.count(), 2500);
  for (long n = 1; n <= windows.count(); ++n) {
    ASSERT_EQ(windows[n].t0_s, windows[n - 1].t1_s);
    ASSERT_GT(windows[n].length_s(), 0.0199);
  }
}

TEST(Windows, LongerThanTheRunIsOneWindow) {
  Windows const windows(10, 1);
  EXPECT_EQ(windows.count(), 1);
  EXPECT_EQ(windows[1].t1_s, 1);
}
