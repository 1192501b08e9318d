// The spline stencil on a lattice of unit squares, columns dealt to ranks, periodic along x:
// against a sum over all cells and images, its transpose, and no jump where a particle crosses a
// face.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "CellStencil.H"

namespace slidewave::foam {
namespace {

using Eigen::MatrixXd;

constexpr int columns = 12, rows = 7;

struct World {
  int rank = 0, size = 1;
  World() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
  }
  int begin(int of) const { return columns * of / size; }
};

CellShape square(int i, int j) {
  CellShape shape;
  shape.centre_m = Vec3(i + 0.5, j + 0.5, 0);
  shape.metric.diagonal() = Vec3(1, 1, 0);
  shape.reach_m = Vec3(spline_reach, spline_reach, 1);
  shape.low_m = Vec3(i, j, -0.5);
  shape.high_m = Vec3(i + 1, j + 1, 0.5);
  return shape;
}

CellStencil latticeStencil(World const& world) {
  std::vector<CellShape> shapes;
  for (int i = world.begin(world.rank); i < world.begin(world.rank + 1); ++i) {
    for (int j = 0; j < rows; ++j) shapes.push_back(square(i, j));
  }
  return CellStencil(shapes, Vec3(columns, 0, 0), MPI_COMM_WORLD);
}

/// One point's weights, in the first of a block's lanes.
std::vector<double> weigh(CellStencil const& stencil, int cell, Vec3 const& point) {
  double points[3 * lanes] = {};
  for (int d = 0; d < 3; ++d) points[lanes * d] = point[d];
  std::vector<double> weights(lanes * stencil.largest());
  stencil.weigh(cell, 1, points, weights.data());
  return weights;
}

/// Amounts of 1 at the points, on all cells of the lattice (column by column).
Eigen::RowVectorXd deposited(World const& world, CellStencil const& stencil,
                             std::vector<Vec3> const& points) {
  std::vector<double> amounts(stencil.columns());
  for (Vec3 const& point : points) {
    int const i = static_cast<int>(point[0]);
    if (i < world.begin(world.rank) || i >= world.begin(world.rank + 1)) continue;
    int const cell = (i - world.begin(world.rank)) * rows + static_cast<int>(point[1]);
    auto const weights = weigh(stencil, cell, point);
    auto const around = stencil.around(cell);
    for (int k = 0; k < around.count; ++k) amounts[around.columns[k]] += weights[lanes * k];
  }
  stencil.collect(amounts.data(), 1);
  Eigen::RowVectorXd all = Eigen::RowVectorXd::Zero(columns * rows);
  all.segment(world.begin(world.rank) * rows, stencil.cells()) =
      Eigen::Map<Eigen::RowVectorXd>(amounts.data(), stencil.cells());
  MPI_Allreduce(MPI_IN_PLACE, all.data(), columns * rows, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

/// The same by a sum over every cell and image.
Eigen::RowVectorXd expected(std::vector<Vec3> const& points) {
  Eigen::RowVectorXd all = Eigen::RowVectorXd::Zero(columns * rows);
  for (Vec3 const& point : points) {
    Eigen::RowVectorXd one = Eigen::RowVectorXd::Zero(columns * rows);
    for (int i = -2; i < columns + 2; ++i) {
      for (int j = 0; j < rows; ++j) {
        double const r = std::hypot(point[0] - i - 0.5, point[1] - j - 0.5);
        one[(i + columns) % columns * rows + j] += r < 0.5   ? 0.75 - r * r
                                                   : r < 1.5 ? (1.5 - r) * (1.5 - r) / 2
                                                             : 0;
      }
    }
    all += one / one.sum();
  }
  return all;
}

std::vector<Vec3> randomPoints(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0, columns), y(0, rows), z(-0.5, 0.5);
  std::vector<Vec3> points;
  for (int k = 0; k < count; ++k) {
    double const px = x(random), py = y(random);
    points.emplace_back(px, py, z(random));
  }
  return points;
}

TEST(CellStencil, IsTheSumOverAllCellsWhereverTheyAre) {
  World const world;
  auto const points = randomPoints(200);
  auto const found = deposited(world, latticeStencil(world), points);
  EXPECT_LT((found - expected(points)).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_NEAR(found.sum(), 200, 1e-11);
}

TEST(CellStencil, FetchingIsTheTransposeOfCollecting) {
  World const world;
  CellStencil const stencil = latticeStencil(world);
  std::mt19937 random(3 + world.rank);
  std::uniform_real_distribution<double> uniform(0, 1);
  MatrixXd a = MatrixXd::NullaryExpr(4, stencil.columns(), [&] { return uniform(random); });
  MatrixXd f = MatrixXd::NullaryExpr(4, stencil.columns(), [&] { return uniform(random); });
  stencil.fetch(f.data(), 4);
  double sums[2] = {a.cwiseProduct(f).sum(), 0};
  stencil.collect(a.data(), 4);
  sums[1] = a.leftCols(stencil.cells()).cwiseProduct(f.leftCols(stencil.cells())).sum();
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_NEAR(sums[0], sums[1], 1e-12 * sums[0]);
}

TEST(CellStencil, NothingJumpsAtAFace) {
  World const world;
  CellStencil const stencil = latticeStencil(world);
  double const step = 1e-7;
  for (double const face : {1.0, 6.0, 9.0}) {  // 6 and 9 lie between ranks, of 2 and of 4
    auto const before = deposited(world, stencil, {Vec3(face - step, 3.3, 0)});
    auto const after = deposited(world, stencil, {Vec3(face + step, 3.3, 0)});
    EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 4 * step);
  }
}

TEST(CellStencil, CellsThatASplineOnlyTouchesAreLeftOut) {
  World const world;
  CellStencil const stencil = latticeStencil(world);
  EXPECT_EQ(stencil.around(rows / 2).count, 9);
}

TEST(CellStencil, CentroidGivesAllToItsCell) {
  CellStencil const stencil(5);
  ASSERT_EQ(stencil.around(4).count, 1);
  EXPECT_EQ(stencil.around(4).columns[0], 4);
  EXPECT_EQ(weigh(stencil, 4, Vec3(1, 2, 3))[0], 1);
}

}  // namespace
}  // namespace slidewave::foam
