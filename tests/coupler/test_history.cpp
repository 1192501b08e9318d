#include <gtest/gtest.h>

#include <sstream>

#include "history.hpp"
#include "scratch.hpp"

using namespace slidewave;

TEST(History, WritesHeaderOnceAndARowAWindow) {
  Scratch const scratch("");
  Window window;
  {
    History history(scratch.path / "history.csv");
    history.add(window, {{"wave_height_m", 0.1}, {"particles", 3}});
    window.index = 1;
    window.t1_s = 0.02;
    history.add(window, {{"wave_height_m", 1.0 / 3}, {"particles", 3}});
  }
  std::ostringstream text;
  text << std::ifstream(scratch.path / "history.csv").rdbuf();
  EXPECT_EQ(text.str(),
            "window,time_s,wave_height_m,particles\n0,0,0.1,3\n1,0.02,0.333333333333,3\n");
}

TEST(History, RefusesOtherColumns) {
  Scratch const scratch("");
  History history(scratch.path / "history.csv");
  history.add(Window(), {{"a", 0}});
  EXPECT_THROW(history.add(Window(), {{"b", 0}}), std::runtime_error);
  EXPECT_THROW(history.add(Window(), {}), std::runtime_error);
}

TEST(History, NamesAFileItCannotWrite) {
  EXPECT_THROW(History("/nonexistent/history.csv"), std::runtime_error);
}
