#include <gtest/gtest.h>

#include "facts.hpp"

using namespace slidewave;

TEST(Facts, NumbersAgreeWithinRoundOff) {
  EXPECT_TRUE(agree("gravity", "(0 0 -9.81)", "0, 0, -9.8100000000001"));
  EXPECT_TRUE(agree("end_time", "50", "5e1"));
  EXPECT_FALSE(agree("end_time", "50", "50.000001"));
  EXPECT_FALSE(agree("gravity", "0 0 -9.81", "0 0"));
  EXPECT_FALSE(agree("density", "1000", "water"));
  EXPECT_TRUE(agree("density", "0", "-0"));
}

TEST(Facts, EmptyAxisAgreesWithBoth) {
  EXPECT_TRUE(agree("boundary", "beb", "bpb"));
  EXPECT_TRUE(agree("boundary", "beb", "bbb"));
  EXPECT_FALSE(agree("boundary", "bpb", "bbb"));
  EXPECT_FALSE(agree("boundary", "bp", "bpb"));
}

TEST(Facts, TableHasARowForEachMismatch) {
  std::string const table = mismatches({{"a", "1"}, {"b", "2"}, {"c", "3"}, {"only", "x"}},
                                       {{"a", "1"}, {"b", "5"}, {"c", "6"}, {"other", "y"}});
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);  // heading and two rows
  EXPECT_NE(table.find("b "), std::string::npos);
  EXPECT_NE(table.find("6"), std::string::npos);
  EXPECT_EQ(table.find("only"), std::string::npos);
  EXPECT_EQ(mismatches({{"a", "1"}}, {{"a", "1"}}), "");
}
