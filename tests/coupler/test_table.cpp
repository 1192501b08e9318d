#include <gtest/gtest.h>

#include "slidewave/table.hpp"

using namespace slidewave;

TEST(Table, KeepsRowsThatStay) {
  Table table;
  table.add({"position", "m", 3});
  table.resize(2);
  table["position"] << 1, 4, 2, 5, 3, 6;
  table.resize(5);
  EXPECT_EQ(table["position"].col(1), Vec3(4, 5, 6));
  table.resize(1);
  EXPECT_EQ(table["position"].col(0), Vec3(1, 2, 3));
  EXPECT_EQ(table["position"].cols(), 1);
}

TEST(Table, HoldsAParticleContiguously) {
  Table table;
  table.add({"velocity", "m/s", 3});
  table.resize(2);
  table["velocity"].col(1) = Vec3(7, 8, 9);
  EXPECT_EQ(table["velocity"].data()[3], 7);
  EXPECT_EQ(table["velocity"].data()[5], 9);
}

TEST(Table, NamesAMissingColumn) {
  Table table;
  try {
    table["torque"];
    FAIL();
  } catch (std::out_of_range const& error) {
    EXPECT_NE(std::string(error.what()).find("torque"), std::string::npos);
  }
}

TEST(Table, CountsBytes) {
  Table table;
  table.add({"radius", "m", 1});
  table.add({"memory", "-", 4});
  EXPECT_EQ(table.bytes_per_particle(), 40);
  EXPECT_TRUE(table.has("memory"));
  EXPECT_FALSE(table.has("drag"));
}

TEST(Table, LentColumnsAreTheLenders) {
  Table table;
  table.add({"velocity", "m/s", 3});
  table.resize(2);
  std::vector<double> theirs = {1, 2, 3, 4, 5, 6};
  table.lend("velocity", theirs.data());
  EXPECT_EQ(std::as_const(table)["velocity"].col(1), Vec3(4, 5, 6));
  table["velocity"].col(0) = Vec3(7, 8, 9);
  EXPECT_EQ(theirs[2], 9);
  table.resize(1);
  EXPECT_THROW(table["velocity"], std::logic_error) << "would be read after the lender's next move";
  table.lend("velocity", theirs.data());
  EXPECT_EQ(table["velocity"].cols(), 1);
  table.resize(0);
  EXPECT_EQ(table["velocity"].sum(), 0);
}

TEST(Table, EmptyColumnsAreUsable) {
  Table table;
  table.add({"force", "N", 3});
  EXPECT_EQ(table["force"].sum(), 0);
}
