#include <gtest/gtest.h>

#include "summary.hpp"

using namespace slidewave;

TEST(Summary, ReadsUnitsFromNames) {
  EXPECT_EQ(unit_of("wave_height_m"), "m");
  EXPECT_EQ(unit_of("slide_speed_m_s"), "m/s");
  EXPECT_EQ(unit_of("given_x_kg_m_s"), "kg m/s");
  EXPECT_EQ(unit_of("mass_lost_kg"), "kg");
  EXPECT_EQ(unit_of("volume_m3"), "m3");
  EXPECT_EQ(unit_of("particles"), "-");
  EXPECT_EQ(unit_of("momentum_defect"), "-");
}
