// "Did you mean", on misspellings that users make.
#include <gtest/gtest.h>

#include "slidewave/physics/nearest_name.hpp"

namespace slidewave {
namespace {

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("window", "window"), 0);
}

TEST(NearestName, FindsTheKeyMeantOrNothing) {
  std::vector<std::string> const keys{"window", "scheme", "patience"};
  EXPECT_EQ(nearest_name("windwo", keys), "window");
  EXPECT_EQ(nearest_name("shceme", keys), "scheme");
  EXPECT_EQ(nearest_name("viscosity", keys), "");
  EXPECT_EQ(unknown_name("key", "windows", keys),
            "\"windows\" is not a key; did you mean \"window\"? Known: window, scheme, patience");
}

}  // namespace
}  // namespace slidewave
