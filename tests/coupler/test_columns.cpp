#include <gtest/gtest.h>

#include "exchange_columns.hpp"

using namespace slidewave;

TEST(Columns, PackAndUnpackAreInverse) {
  Table table;
  table.add({"velocity", "m/s", 3});
  table.add({"radius", "m", 1});
  table.resize(5);
  table["velocity"].setRandom();
  table["radius"].setRandom();
  Table const before = table;
  std::vector<int> const rows = {4, 1, 2};
  std::vector<double> buffer(12);
  pack(before["velocity"], rows.data(), 3, buffer.data());
  pack(before["radius"], rows.data(), 3, buffer.data() + 9);
  EXPECT_EQ(buffer[3], before["velocity"](0, 1));
  EXPECT_EQ(buffer[9], before["radius"](0, 4));
  table["velocity"].setZero();
  unpack(buffer.data(), rows.data(), 3, table["velocity"]);
  for (int row : rows) {
    EXPECT_EQ(table["velocity"].col(row), before["velocity"].col(row));
  }
  EXPECT_EQ(table["velocity"].col(0), Vec3::Zero());
}

TEST(Columns, UnpackOnlyWhatIsTaken) {
  Table table;
  table.add({"radius", "m", 1});
  table.resize(2);
  std::vector<double> const message = {1, 2, 3};
  std::vector<char> const taken = {1, 0, 1};
  std::vector<int> const rows = {1, 0};
  unpack(message.data(), rows.data(), 3, table["radius"], taken.data());
  EXPECT_EQ(table["radius"](0, 1), 1);
  EXPECT_EQ(table["radius"](0, 0), 3);
}

TEST(Columns, FindNumbersThatAreNone) {
  double values[] = {0, -1e308, 4e-320, 1};
  EXPECT_TRUE(all_finite(values, 4));
  for (double bad : {double(NAN), -double(NAN), double(INFINITY), -double(INFINITY)}) {
    values[2] = bad;
    EXPECT_FALSE(all_finite(values, 4));
    EXPECT_TRUE(all_finite(values, 2));
    EXPECT_EQ(first_not_finite(values, 2, 2), 1);
    EXPECT_EQ(first_not_finite(values, 1, 2), -1);
  }
}
