#include <gtest/gtest.h>

#include "two_sides.hpp"

using namespace slidewave;

TEST(World, JoinsByRole) {
  TwoSides sides;
  World const& world = sides.session.world;
  int const all = TwoSides::world_size();
  EXPECT_EQ(world.has_partner(), all > 1);
  EXPECT_EQ(world.size + world.partner_size, all);
  EXPECT_EQ(world.rank, TwoSides::world_rank() / 2);
}

TEST(Agreement, SumsOverOneSideOrBoth) {
  TwoSides sides;
  Agreement const& agreement = sides.session.agreement;
  double one[2] = {1, 2.0 * TwoSides::world_rank()};
  agreement.sum_all(one, 2, "a test");
  int const n = TwoSides::world_size();
  EXPECT_EQ(one[0], n);
  EXPECT_EQ(one[1], n * (n - 1));
  double side = 1;
  agreement.sum_side(&side, 1, "a test");
  EXPECT_EQ(side, sides.session.world.size);
}

TEST(Agreement, SharesAndSwapsText) {
  TwoSides sides;
  Agreement const& agreement = sides.session.agreement;
  std::string text =
      sides.session.is_root() ? std::string("from the first ") + name_of(sides.session.role) : "";
  agreement.share_on_side(text, "a test");
  EXPECT_EQ(text, std::string("from the first ") + name_of(sides.session.role));
  if (sides.session.world.has_partner() && sides.session.is_root()) {
    std::string const answer = agreement.swap_between_roots(text, "a test");
    EXPECT_EQ(answer, std::string("from the first ") + name_of(other(sides.session.role)));
  }
}

TEST(Agreement, GathersOnTheFirstRank) {
  TwoSides sides;
  World const& world = sides.session.world;
  auto const all = sides.session.agreement.gather_on_side({1.0 * world.rank, 7}, "a test");
  if (world.rank == 0) {
    ASSERT_EQ(all.size(), 2u * world.size);
    EXPECT_EQ(all[2 * world.size - 2], world.size - 1);
  } else {
    EXPECT_TRUE(all.empty());
  }
}
