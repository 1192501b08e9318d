#include <gtest/gtest.h>

#include "sparse.hpp"
#include "two_sides.hpp"

using namespace slidewave;

namespace {

/// Dem rank s sends to fluid rank r in round k unless this says otherwise.
bool sends(int s, int r, int k) {
  return (s + r + k) % 3 != 0;
}

}  // namespace

TEST(Sparse, EveryMessageArrivesOnceInOrderOfSource) {
  TwoSides sides;
  World const& world = sides.session.world;
  SparseSender sender(world, sides.session.waiter);
  SparseReceiver receiver(world, sides.session.waiter);
  for (int k = 0; k < 50; ++k) {
    int const tag = 20 + k % 2;
    if (sides.is_fluid()) {
      auto const& messages = receiver.collect(tag, "test messages");
      std::vector<int> expected;
      for (int s = 0; s < world.partner_size; ++s) {
        if (sends(s, world.rank, k)) {
          expected.push_back(s);
        }
      }
      ASSERT_EQ(messages.size(), expected.size());
      for (std::size_t m = 0; m < messages.size(); ++m) {
        int const s = messages[m]->source;
        EXPECT_EQ(s, expected[m]);
        ASSERT_EQ(messages[m]->data.size(), 1u + 2000u * (k % 3));  // eager and rendezvous
        EXPECT_EQ(messages[m]->data.back(), 100 * k + s);
      }
    } else {
      std::vector<double> const buffer(1 + 2000 * (k % 3), 100 * k + world.rank);
      for (int r = 0; r < world.partner_size; ++r) {
        if (sends(world.rank, r, k)) {
          sender.send(r, buffer, tag);
        }
      }
      sender.finish("test messages");
    }
  }
}
