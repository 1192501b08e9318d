// The kernel on a made-up mesh: conservation, self-adjointness, width, transpose, bounding.
#include <gtest/gtest.h>

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
  MatrixXd const nowhere = MatrixXd::Zero(3, static_cast<long>(cells.size()));
  kernel.place(Table::ConstColumn(nowhere.data(), 3, nowhere.cols()), cells);
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
  MatrixXd sa = a, sb = b, s1 = one;
  smoother.smooth(sa);
  smoother.smooth(sb);
  smoother.smooth(s1);
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
  smoother.smooth(point);
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
  place(kernel, {3, 3, 17, 29, 0});
  MatrixXd const amounts = (MatrixXd(1, 5) << 1, 2, 0.5, 3, 0.1).finished();
  MatrixXd const field =
      MatrixXd::NullaryExpr(1, 30, [](long, long i) { return std::sin(0.3 * i); });
  double const cells = product(kernel.smoother().graph(), kernel.spread(amounts), field);
  double const particles = (amounts * kernel.gather(field).transpose())(0);
  EXPECT_NEAR(cells, particles, 1e-12);
}

TEST(SolidFraction, KeepsTheVolumeWhenItIsBounded) {
  ParticleKernel kernel = centroidKernel(row(30), 1.5);
  place(kernel, {15, 15, 16});
  SolidFraction solid;
  solid.deposit(kernel, (MatrixXd(1, 3) << 2, 2, 1.5).finished());
  EXPECT_NEAR(solid.volume_m3(kernel), 5.5, 5.5e-12);
  EXPECT_GE(solid.voidFraction().minCoeff(), SolidFraction::smallest_void_fraction - 1e-12);
  EXPECT_GT(solid.moved_m3(), 0);
}

TEST(SolidFraction, LeavesAModestDepositAlone) {
  ParticleKernel kernel = centroidKernel(row(30), 3);
  place(kernel, {15});
  SolidFraction solid;
  solid.deposit(kernel, MatrixXd::Constant(1, 1, 0.5));
  EXPECT_EQ(solid.moved_m3(), 0);
}

}  // namespace
}  // namespace slidewave::foam
