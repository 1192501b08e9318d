// Large bodies on a row of cells dealt out to the ranks, against a scan of the whole row.
#include <gtest/gtest.h>

#include <random>

#include "LargeBodies.H"

namespace slidewave::foam {
namespace {

/// This rank's part of a row of `cells` unit cells; parts may be cut anywhere.
MeshGraph part_of_row(int first, int last, int rank, int size) {
  MeshGraph graph;
  graph.comm = MPI_COMM_WORLD;
  for (int cell = first; cell < last; ++cell) {
    graph.volume_m3.push_back(1);
    if (cell > first) graph.links.push_back({cell - first - 1, cell - first, 1});
  }
  if (rank > 0) graph.borders.push_back({rank - 1, rank - 1, {0}, {1}});
  if (rank + 1 < size) graph.borders.push_back({rank + 1, rank, {last - first - 1}, {1}});
  return graph;
}

/// Cells of the runs of wet cells that hold a fifth of the sum, by walking the row.
std::vector<char> walk(std::vector<char> const& wet, std::vector<double> const& amount) {
  int const cells = static_cast<int>(wet.size());
  std::vector<char> large(cells, 0);
  double all = 0;
  for (int cell = 0; cell < cells; ++cell) all += wet[cell] ? amount[cell] : 0;
  for (int begin = 0; begin < cells; ++begin) {
    if (!wet[begin] || (begin > 0 && wet[begin - 1])) continue;
    int end = begin;
    double sum = 0;
    for (; end < cells && wet[end]; ++end) sum += amount[end];
    if (sum >= 0.2 * all) std::fill(large.begin() + begin, large.begin() + end, 1);
  }
  return large;
}

TEST(LargeBodies, IsTheSameForAnyRanks) {
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  std::mt19937 random(7);
  for (double const share : {0.0, 0.3, 0.6, 0.9, 1.0}) {
    for (int trial = 0; trial < 20; ++trial) {
      int const cells = 40;
      std::vector<char> wet(cells);
      std::vector<double> amount(cells);
      for (int cell = 0; cell < cells; ++cell) {
        wet[cell] = std::uniform_real_distribution<double>(0, 1)(random) < share;
        amount[cell] = std::uniform_real_distribution<double>(0.5, 1)(random);
      }
      int const first = cells * rank / size, last = cells * (rank + 1) / size;
      MeshGraph const graph = part_of_row(first, last, rank, size);
      std::vector<char> const mine(wet.begin() + first, wet.begin() + last);
      Eigen::MatrixXd const weight =
          Eigen::Map<Eigen::MatrixXd const>(amount.data() + first, 1, last - first);
      std::vector<char> const expected = walk(wet, amount);
      EXPECT_EQ(largeBodies(graph, mine, weight, 0.2),
                std::vector<char>(expected.begin() + first, expected.begin() + last))
          << "share " << share << " trial " << trial;
    }
  }
}

}  // namespace
}  // namespace slidewave::foam
