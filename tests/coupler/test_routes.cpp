#include <gtest/gtest.h>

#include <random>

#include "routes.hpp"

using namespace slidewave;

TEST(CoarseMap, FindsLowestAndOthers) {
  CoarseMap const map({{Vec3(0, 0, 0), Vec3(1, 1, 1)},
                       {Vec3(0.9, 0, 0), Vec3(2, 1, 1)},
                       {Vec3(2, 0, 0), Vec3(3, 1, 1)}});
  std::vector<int> ranks;
  EXPECT_EQ(map.first(Vec3(0.95, 0.5, 0.5), 0), 0);
  map.others(Vec3(0.95, 0.5, 0.5), 0, 0, ranks);
  EXPECT_EQ(ranks, std::vector<int>{1});
  EXPECT_EQ(map.first(Vec3(3.05, 0.5, 0.5), 0), -1);
  EXPECT_EQ(map.first(Vec3(3.05, 0.5, 0.5), 0.1), 2);
  EXPECT_NEAR(map.distance_m(Vec3(3.3, 0.5, 1.4)), 0.5, 1e-15);
}

TEST(CoarseMap, EmptyRankHasNoBox) {
  CoarseMap const map({Box(), {Vec3(0, 0, 0), Vec3(1, 1, 1)}});
  EXPECT_EQ(map.first(Vec3(0.5, 0.5, 0.5), 0.1), 1);
}

TEST(Groups, SortLikeBruteForce) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<int> destination(random() % 200);
    for (int& d : destination) {
      d = static_cast<int>(random() % 6) - 1;
    }
    Groups groups;
    groups.sort(destination, 5);
    std::vector<std::vector<int>> expected(5);
    for (std::size_t row = 0; row < destination.size(); ++row) {
      if (destination[row] >= 0) {
        expected[destination[row]].push_back(static_cast<int>(row));
      }
    }
    int seen = 0;
    for (int g = 0; g < groups.size(); ++g) {
      std::vector<int> const rows(groups.rows(g), groups.rows(g) + groups.count(g));
      EXPECT_EQ(rows, expected[groups.destination(g)]);
      EXPECT_FALSE(rows.empty());
      ++seen;
    }
    EXPECT_EQ(seen, std::count_if(expected.begin(), expected.end(),
                                  [](auto const& rows) { return !rows.empty(); }));
  }
}
