// Routing and exchange of both sides against brute force: every particle has exactly one owner, the
// one that geometry says, and gets its own answer back.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "inbox.hpp"
#include "outbox.hpp"
#include "two_sides.hpp"

using namespace slidewave;

namespace {

constexpr double radius = 0.05;

/// Slabs of the unit cube along x; boxes claim more than is owned, so that first guesses miss.
struct Slabs : FluidEngine {
  int rank;
  int size;
  mutable long located = 0;
  Slabs(int r, int n) : rank(r), size(n) {}
  double low() const { return static_cast<double>(rank) / size; }
  double high() const { return (rank + 1.0) / size; }
  static Box box(int rank, int size) {
    return {Vec3(static_cast<double>(rank) / size - 0.3, 0, 0),
            Vec3((rank + 1.0) / size + 0.3, 1, 1)};
  }
  Box bounds() const override { return box(rank, size); }
  std::vector<Field> samples() const override { return {}; }
  Home locate(Vec3 const& x, int hint) override {
    EXPECT_LT(hint, 1000);
    ++located;
    Vec3 const inside = x.cwiseMax(Vec3(low(), 0, 0)).cwiseMin(Vec3(high(), 1, 1));
    return {static_cast<int>(100 * inside[1]), (x - inside).norm()};
  }
  void place(Table::ConstColumn, std::vector<int> const&) override {}
  void deposit(Table::ConstColumn) override {}
  void exchange(Table::ConstColumn, Table::ConstColumn, Table::ConstColumn) override {}
  void advance(Window const&) override {}
  void sample(std::string const&, Table::Column) override {}
  Vec3 given_impulse() const override { return Vec3::Zero(); }
  double solid_volume_m3() const override { return 0; }
  Vec3 solid_pressure_force() const override { return Vec3::Zero(); }
};

Agreed agreement(int fluid_ranks) {
  Agreed agreed;
  agreed.models.outside = Outside::ignore;
  agreed.layout = Layout::of(agreed.models);
  for (int r = 0; r < fluid_ranks; ++r) {
    agreed.fluid_boxes.push_back(Slabs::box(r, fluid_ranks));
  }
  return agreed;
}

double distance_to_cube(Vec3 const& x) {
  return (x - x.cwiseMax(Vec3::Zero()).cwiseMin(Vec3::Ones())).norm();
}

void fluid_side(Session::Impl& session, int windows) {
  World const& world = session.world;
  Agreed const agreed = agreement(world.size);
  Slabs engine(world.rank, world.size);
  Inbox inbox(session, agreed);
  Table table;
  for (auto const& fields : {agreed.layout.to_fluid, agreed.layout.to_dem}) {
    for (Field const& field : fields) {
      table.add(field);
    }
  }
  std::vector<int> cell;
  for (long n = 0; n < windows; ++n) {
    EXPECT_EQ(inbox.collect(engine, table, cell, n, {}).stop, n == windows - 1);
    ASSERT_EQ(table.size(), static_cast<long>(cell.size()));
    EXPECT_TRUE(std::is_sorted(cell.begin(), cell.end()));
    for (long i = 0; i < table.size(); ++i) {
      Vec3 const x = table["position"].col(i);
      EXPECT_EQ(cell[i], engine.locate(x, -1).cell);
      // carried in memory, less the impulse
      EXPECT_TRUE(table["ledger"].col(i).isApprox(2 * x, 1e-12));
      table["drag"](0, i) = world.rank + 1;
      table["fluid_velocity"].col(i) = x;
      table["force"].col(i) = -x;
      table["given"].col(i) = 3 * x;
    }
    double seen = static_cast<double>(table.size());
    session.agreement.sum_all(&seen, 1, "the test");
    EXPECT_EQ(seen, 0) << "fluid ranks hold as many particles as dem ranks have inside";
    inbox.answer(table, cell, n);
  }
}

void dem_side(Session::Impl& session, int windows) {
  World const& world = session.world;
  Agreed const agreed = agreement(world.partner_size);
  Outbox outbox(session, agreed);
  Table table;
  Table answers;
  for (Field const& field : Layout::gathered(agreed.models, true)) {
    table.add(field);
  }
  for (Field const& field : Layout::answered(agreed.models)) {
    answers.add(field);
  }
  std::vector<double> own_memory(4 * 700);
  std::mt19937 random(world.rank);
  auto const uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  long const count = world.rank == 0 ? 700 : 333;
  table.resize(count);
  for (long i = 0; i < count; ++i) {
    table["position"].col(i) = Vec3(uniform(0, 1), uniform(0, 1), uniform(0, 1));
  }
  table["position"].col(0) = Vec3(0.5, 0.5, 0.5);  // on the face between ranks
  table["radius"].setConstant(radius);
  table["velocity"].setOnes();
  for (long n = 0; n < windows; ++n) {
    for (long i = 0; i < count && n > 0; ++i) {  // some leave the cube, a little or far
      table["position"].col(i) += 0.05 * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    }
    auto const x = table["position"];
    table["memory"].topRows<3>() = 5 * x;
    table["impulse"] = 3 * x;
    long inside = 0;
    long nearest = 0;
    double volume = 0;
    for (long i = 0; i < count; ++i) {
      double const distance = distance_to_cube(x.col(i));
      inside += distance <= radius;
      nearest += distance <= radius && distance > 0;
      volume += distance <= radius ? 4 * M_PI / 3 * std::pow(radius, 3) : 0;
    }
    bool const wish = n == windows - 1 && world.rank == world.size - 1;
    EXPECT_EQ(outbox.send(table, n, {wish, false}).stop, n == windows - 1);
    EXPECT_EQ(outbox.census().outside, count - inside);
    EXPECT_EQ(outbox.census().nearest_cell, nearest);
    EXPECT_NEAR(outbox.census().volume_m3, volume, 1e-12 * volume);
    double seen = -static_cast<double>(inside);
    session.agreement.sum_all(&seen, 1, "the test");
    EXPECT_EQ(seen, 0);
    answers.resize(table.size());
    // An engine may lend its own array to both tables.
    answers.lend("memory", n % 2 == 1 ? table["memory"].data() : own_memory.data());
    outbox.receive(table, answers, n);
    for (long i = 0; i < count; ++i) {
      if (distance_to_cube(x.col(i)) > radius) {
        EXPECT_EQ(answers["drag"](0, i), 0);
        EXPECT_EQ(answers["force"].col(i), Vec3::Zero());
        EXPECT_TRUE(answers["memory"].col(i).head<3>().isApprox(2 * x.col(i), 1e-12));
        continue;
      }
      EXPECT_EQ(answers["fluid_velocity"].col(i), x.col(i));
      EXPECT_EQ(answers["force"].col(i), -x.col(i));
      EXPECT_TRUE(answers["memory"].col(i).head<3>().isApprox(5 * x.col(i), 1e-12));
      int const n_fluid = world.partner_size;
      int const expected = std::clamp(static_cast<int>(x(0, i) * n_fluid), 0, n_fluid - 1);
      bool const on_face = x(0, i) * n_fluid == expected && expected > 0;
      int const owner = static_cast<int>(answers["drag"](0, i)) - 1;
      EXPECT_EQ(owner, on_face ? expected - 1 : expected) << x.col(i).transpose();
      EXPECT_EQ(HomeCode::decode(answers["memory"](3, i)).owner, owner);
    }
    table["memory"] = answers["memory"];
  }
}

}  // namespace

TEST(Exchange, OneOwnerAndItsOwnAnswer) {
  TwoSides sides;
  if (sides.is_fluid()) {
    fluid_side(sides.session, 12);
  } else {
    dem_side(sides.session, 12);
  }
}
