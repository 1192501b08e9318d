#include <gtest/gtest.h>

#include "progress.hpp"

using namespace slidewave;

namespace {

Window at(double time_s) {
  Window window;
  window.t1_s = time_s;
  return window;
}

}  // namespace

TEST(Progress, SpeaksAtStartAndEndAndNotBetween) {
  Progress progress(10, "height_m");
  EXPECT_NE(progress.line(at(0), {{"height_m", 2.5}}, 0, 0).find("height_m 2.5"),
            std::string::npos);
  EXPECT_EQ(progress.line(at(5), {{"height_m", 3}}, 0, 0), "");  // within two seconds
  std::string const last = progress.line(at(10), {{"height_m", 3}}, 1, 2);
  EXPECT_NE(last.find("100 %"), std::string::npos);
  EXPECT_NE(last.find("height_m 3"), std::string::npos);
  EXPECT_EQ(last.find('\r'), std::string::npos);
}
