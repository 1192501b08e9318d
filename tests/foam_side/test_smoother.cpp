// The kernel on a made-up mesh: conservation, self-adjointness, width, transpose, bounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "ParticleKernel.H"
#include "SolidFraction.H"

namespace slidewave::foam {
namespace {

using Eigen::MatrixXd;

/// A row of cells of growing length, or of a length of 1.
MeshGraph row(int cells, double growth = 1) {
  MeshGraph graph;
  graph.comm = MPI_COMM_WORLD;
  double length = 1;
  for (int i = 0; i < cells; ++i, length *= growth) {
    graph.volume_m3.push_back(length);
    if (i > 0) graph.links.push_back({i - 1, i, 2 / (length * (1 + 1 / growth))});
  }
  return graph;
}

ParticleKernel centroidKernel(MeshGraph const& graph, double length) {
  return {Smoother(graph, length), CellStencil(graph.cells())};
}

void place(ParticleKernel& kernel, std::vector<int> const& cells) {
  static MatrixXd const nowhere = MatrixXd::Zero(3, 10);
  kernel.place(Table::ConstColumn(nowhere.data(), 3, static_cast<long>(cells.size())), cells);
}

MatrixXd smoothed(Smoother const& smoother, MatrixXd const& one) {
  CellValues values(one.data(), one.data() + one.size()), spare;
  for (int i = 0; i < smoother.steps(); ++i) {
    smoother.step(values, spare, static_cast<int>(one.rows()), smoother.everywhere());
  }
  return Eigen::Map<MatrixXd>(values.data(), one.rows(), one.cols());
}

Table::ConstColumn column(MatrixXd const& values) {
  return {values.data(), values.rows(), values.cols()};
}

double product(MeshGraph const& graph, MatrixXd const& a, MatrixXd const& b) {
  Eigen::Map<Eigen::RowVectorXd const> const volume(graph.volume_m3.data(), graph.cells());
  return (a.array() * b.array() * volume.array()).sum();
}

TEST(Smoother, IsConservativeSelfAdjointAndKeepsConstants) {
  Smoother const smoother(row(40, 1.05), 5);
  ASSERT_GT(smoother.steps(), 3);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  MatrixXd const a = MatrixXd::NullaryExpr(1, 40, [&] { return uniform(random); });
  MatrixXd const b = MatrixXd::NullaryExpr(1, 40, [&] { return uniform(random); });
  MatrixXd const one = MatrixXd::Ones(1, 40);
  MatrixXd const sa = smoothed(smoother, a), sb = smoothed(smoother, b),
                 s1 = smoothed(smoother, one);
  double const scale = product(smoother.graph(), a, one);
  EXPECT_NEAR(product(smoother.graph(), sa, one), scale, 1e-12 * scale);
  EXPECT_NEAR(product(smoother.graph(), sa, b), product(smoother.graph(), a, sb), 1e-12 * scale);
  EXPECT_LT((s1 - one).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Smoother, HasTheAskedWidthAndStaysPositive) {
  double const length = 4;
  Smoother const smoother(row(101), length);
  MatrixXd point = MatrixXd::Zero(1, 101);
  point(0, 50) = 1;
  point = smoothed(smoother, point);
  double variance = 0;
  for (int i = 0; i < 101; ++i) variance += point(0, i) * (i - 50) * (i - 50);
  EXPECT_NEAR(variance, length * length / 2, 1e-10);
  EXPECT_GE(point.minCoeff(), 0);
}

TEST(Smoother, ZeroLengthChangesNothing) {
  Smoother const smoother(row(5), 0);
  EXPECT_EQ(smoother.steps(), 0);
}

TEST(ParticleKernel, SampleIsTheTransposeOfDeposit) {
  ParticleKernel kernel = centroidKernel(row(30, 1.1), 6);
  place(kernel, {0, 3, 3, 17, 29});
  MatrixXd const amounts = (MatrixXd(1, 5) << 0.1, 1, 2, 0.5, 3).finished();
  MatrixXd const field =
      MatrixXd::NullaryExpr(1, 30, [](long, long i) { return std::sin(0.3 * i); });
  MatrixXd const density = kernel.spread(1, [&](int i, double* out) { *out = amounts(0, i); });
  double const cells = product(kernel.smoother().graph(), density, field);
  kernel.fields(1) = field;
  double particles = 0;
  kernel.gather([&](int i, double const* value, int) { particles += amounts(0, i) * *value; });
  EXPECT_NEAR(cells, particles, 1e-12);
}

TEST(ParticleKernel, TakesOnlySortedParticles) {
  ParticleKernel kernel = centroidKernel(row(30, 1.1), 6);
  EXPECT_THROW(place(kernel, {3, 2}), std::invalid_argument);
}

/// A lattice of n x n x n unit cubes.
ParticleKernel latticeKernel(int n, double length) {
  MeshGraph graph;
  graph.comm = MPI_COMM_WORLD;
  graph.volume_m3.assign(n * n * n, 1.0);
  std::vector<CellShape> shapes;
  for (int cell = 0; cell < n * n * n; ++cell) {
    int const at[3] = {cell % n, cell / n % n, cell / (n * n)};
    CellShape shape;
    shape.low_m = Vec3(at[0], at[1], at[2]);
    shape.high_m = shape.low_m + Vec3::Ones();
    shape.centre_m = shape.low_m + 0.5 * Vec3::Ones();
    shape.metric.setIdentity();
    shape.reach_m = Vec3::Constant(spline_reach);
    shapes.push_back(shape);
    for (int d = 0, step = 1; d < 3; ++d, step *= n) {
      if (at[d] > 0) graph.links.push_back({cell - step, cell, 1.0});
    }
  }
  return {Smoother(graph, length), CellStencil(shapes, Vec3::Zero(), MPI_COMM_WORLD)};
}

/// Several fields at once, and more particles in a cell than are worked on together, against the
/// same one field and one particle at a time.
TEST(ParticleKernel, ManyAtOnceAreAsOneByOne) {
  int const n = 8, count = 220;  // more blocks than are worked on together
  ParticleKernel kernel = latticeKernel(n, 2);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  MatrixXd points(3, count);
  std::vector<int> cells;
  for (int i = 0; i < count; ++i) {  // three full cells, the others one each
    int const cell = i < 17 ? 0 : i < 30 ? 62 : i < 212 ? 62 + 2 * (i - 29) : 511;
    for (int d = 0, step = 1; d < 3; ++d, step *= n)
      points(d, i) = cell / step % n + uniform(random);
    cells.push_back(cell);
  }
  MatrixXd const amounts = MatrixXd::NullaryExpr(7, count, [&] { return uniform(random); });
  MatrixXd const fields = MatrixXd::NullaryExpr(7, n * n * n, [&] { return uniform(random); });
  kernel.place(column(points), cells);
  MatrixXd const density = kernel
                               .spread(7,
                                       [&](int i, double* out) {
                                         for (int c = 0; c < 8; ++c)
                                           out[c] = c < 7 ? amounts(c, i) : 0;
                                       })
                               .topRows(7);
  kernel.fields(7).topRows(7) = fields;
  MatrixXd values(7, count);
  kernel.gather([&](int i, double const* value, int stride) {
    for (int c = 0; c < 7; ++c) values(c, i) = value[c * stride];
  });

  kernel.fields(7).topRows(7) = fields;
  MatrixXd again = MatrixXd::Zero(7, count);
  long next = 0, calls = 0;
  MatrixXd const at_once =
      kernel
          .exchange(
              7,
              [&](int i, double const* value, int stride) {
                for (int c = 0; c < 7; ++c) again(c, i) = value[c * stride];
              },
              [&](long first, long some) {  // after they took, before they give
                EXPECT_EQ(first, next);
                next += some;
                ++calls;
                EXPECT_TRUE(again.middleCols(first, some) == values.middleCols(first, some));
                again.middleCols(first, some) = amounts.middleCols(first, some);
              },
              [&](int i, double* out) {
                for (int c = 0; c < 7; ++c) out[c] = again(c, i);
              })
          .topRows(7);
  EXPECT_EQ(next, count);
  EXPECT_GT(calls, 2);
  EXPECT_EQ(at_once, density);

  MatrixXd sum = MatrixXd::Zero(7, n * n * n);
  for (int i = 0; i < count; ++i) {
    MatrixXd const point = points.col(i);
    kernel.place(column(point), {cells[i]});
    for (int c = 0; c < 7; ++c) {
      sum.row(c) += kernel.spread(1, [&](int, double* out) { *out = amounts(c, i); });
      kernel.fields(1) = fields.row(c);
      kernel.gather(
          [&](int, double const* value, int) { EXPECT_NEAR(values(c, i), *value, 1e-14); });
    }
  }
  EXPECT_LT((density - sum).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_NEAR(density.sum(), amounts.sum(), 1e-11);
}

/// Particles that drift, cross cells, jump and scatter, against smoothing everywhere: the same
/// bits.
TEST(ParticleKernel, SmoothsNearParticlesAsItWouldEverywhere) {
  int const n = 14, count = 9, all = n * n * n;
  double const length = 1.3;
  ParticleKernel kernel = latticeKernel(n, length), bare = latticeKernel(n, 0);
  Smoother const& smoother = kernel.smoother();
  ASSERT_GT(smoother.steps(), 4);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  MatrixXd points = MatrixXd::NullaryExpr(3, count, [&] { return 2 + uniform(random); });
  auto const give = [](int i, double* out) {
    for (int c = 0; c < 4; ++c) out[c] = 1 + i + 0.1 * c;
  };
  for (int time = 0; time < 12; ++time) {
    if (time == 6) points.array() += 6.2;
    if (time == 9) points = MatrixXd::NullaryExpr(3, count, [&] { return n * uniform(random); });
    if (time < 9) points.row(0).array() += 0.31;
    auto const cell_of = [&](long i) {
      return static_cast<int>(points(0, i)) + n * static_cast<int>(points(1, i)) +
             n * n * static_cast<int>(points(2, i));
    };
    std::vector<long> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](long a, long b) { return cell_of(a) < cell_of(b); });
    MatrixXd sorted(3, count);
    std::vector<int> cells;
    for (long const i : order) {
      sorted.col(static_cast<long>(cells.size())) = points.col(i);
      cells.push_back(cell_of(i));
    }
    kernel.place(column(sorted), cells);
    bare.place(column(sorted), cells);
    EXPECT_EQ(MatrixXd(kernel.spread(4, give)), smoothed(smoother, bare.spread(4, give)));

    MatrixXd const fields = MatrixXd::NullaryExpr(4, all, [&] { return uniform(random); });
    kernel.fields(4) = fields;
    bare.fields(4) = smoothed(smoother, fields);
    std::vector<double> taken[2];
    for (ParticleKernel* one : {&kernel, &bare}) {
      one->gather([&](int, double const* value, int stride) {
        for (int c = 0; c < 4; ++c) taken[one == &bare].push_back(value[c * stride]);
      });
    }
    EXPECT_EQ(taken[0], taken[1]);
  }
}

struct LaneLoopsOf27Cells : testing::TestWithParam<int> {
  int const components = GetParam();
  std::vector<SplineCentre> centres;
  std::vector<int> near;
  std::mt19937 random{9};
  std::vector<double> numbers(int count) {
    std::vector<double> list(count);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (double& x : list) x = uniform(random);
    return list;
  }
  LaneLoopsOf27Cells() {
    for (int k = 0; k < 27; ++k) {
      centres.push_back({{k % 3 - 0.5, k / 3 % 3 - 0.5, k / 9 - 0.5}, {1, 0.8, 1.2, 0.1, 0, 0.2}});
      near.push_back(k);
    }
  }
  static void expectSame(std::vector<double> const& a, std::vector<double> const& b) {
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-14);
  }
};

/// Both sets of instructions do the same, to round-off.
TEST_P(LaneLoopsOf27Cells, FastOnesAreTheSame) {
  int const active = 5;
  auto points = numbers(3 * lanes);
  points[active - 1] = 90;  // far away: all to its own cell
  auto const fields = numbers(components * 27);
  auto values = numbers(components * lanes);
  std::fill(values.begin() + components * active, values.end(), 0.0);
  std::vector<Pull> const pulls{{3, 0.1}, {1, 0.2}, {4, 0.1}, {2, 0.3}};
  std::vector<int> const first{0, 1, 4};
  std::vector<double> weights[2], taken[2], added[2], pulled[2];
  for (int way = 0; way < 2; ++way) {
    auto const& loops = way == 0 ? plainLoops() : laneLoops();
    weights[way].resize(27 * lanes);
    taken[way].resize(components * lanes);
    added[way] = fields;
    pulled[way].resize(components * 2);
    loops.weights(centres.data(), near.data(), 27, 13, active, points.data(), weights[way].data());
    loops.take(weights[way].data(), near.data(), 27, active, fields.data(), components,
               taken[way].data());
    loops.add(weights[way].data(), near.data(), 27, values.data(), components, added[way].data());
    loops.pull(pulls.data(), first.data(), {0, 2}, fields.data(), components, pulled[way].data());
    for (int c = 0; c < components; ++c) {  // what lanes beyond the active ones hold is free
      for (int l = active; l < lanes; ++l) taken[way][lanes * c + l] = 0;
    }
  }
  expectSame(taken[0], taken[1]);
  expectSame(added[0], added[1]);
  expectSame(pulled[0], pulled[1]);
  for (int k = 0; k < 27; ++k) {
    for (int l = 0; l < active; ++l) {
      EXPECT_NEAR(weights[0][lanes * k + l], weights[1][lanes * k + l], 1e-15);
    }
    EXPECT_EQ(weights[1][lanes * k + active - 1], k == 13 ? 1 : 0);
  }
}

TEST_P(LaneLoopsOf27Cells, UprightWeightsAreTheSameWhereNothingIsTilted) {
  for (SplineCentre& centre : centres) std::fill_n(centre.metric + 3, 3, 0.0);
  auto const points = numbers(3 * lanes);
  std::vector<double> general(27 * lanes), upright(27 * lanes);
  for (LaneLoops const* loops : {&plainLoops(), &laneLoops()}) {
    loops->weights(centres.data(), near.data(), 27, 13, lanes, points.data(), general.data());
    loops->uprightWeights(centres.data(), near.data(), 27, 13, lanes, points.data(),
                          upright.data());
    expectSame(general, upright);
  }
}

INSTANTIATE_TEST_SUITE_P(Components, LaneLoopsOf27Cells, testing::Values(1, 4, 8, 12, 16, 24));

TEST(SolidFraction, KeepsTheVolumeWhenItIsBounded) {
  ParticleKernel kernel = centroidKernel(row(30), 1.5);
  place(kernel, {15, 15, 16});
  SolidFraction solid;
  solid.deposit(kernel, column((MatrixXd(1, 3) << 2, 2, 1.5).finished()));
  EXPECT_NEAR(solid.volume_m3(kernel), 5.5, 5.5e-12);
  for (int cell = 0; cell < 30; ++cell) {
    EXPECT_GE(solid.voidFraction(cell), SolidFraction::smallest_void_fraction);
    EXPECT_LE(solid.voidFraction(cell), 1);
  }
  EXPECT_GT(solid.moved_m3(), 0);
}

TEST(SolidFraction, LeavesAModestDepositAlone) {
  ParticleKernel kernel = centroidKernel(row(30), 3);
  place(kernel, {15});
  SolidFraction solid;
  solid.deposit(kernel, column(MatrixXd::Constant(1, 1, 0.5)));
  EXPECT_EQ(solid.moved_m3(), 0);
}

}  // namespace
}  // namespace slidewave::foam
