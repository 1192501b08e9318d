#include <algorithm>
#include <numeric>

#include "LargeBodies.H"

namespace slidewave::foam {
namespace {

// Bodies of this rank's cells: union of linked wet cells, the lowest cell stands for its body.
std::vector<int> bodiesOfRank(MeshGraph const& graph, std::vector<char> const& wet) {
  std::vector<int> parent(graph.cells());
  std::iota(parent.begin(), parent.end(), 0);
  auto const root = [&](int cell) {
    while (parent[cell] != cell) {
      parent[cell] = parent[parent[cell]];
      cell = parent[cell];
    }
    return cell;
  };
  for (MeshGraph::Link const& link : graph.links) {
    if (!wet[link.a] || !wet[link.b]) continue;
    int const a = root(link.a), b = root(link.b);
    parent[std::max(a, b)] = std::min(a, b);
  }
  for (int cell = 0; cell < graph.cells(); ++cell) parent[cell] = root(cell);
  return parent;
}

// The lowest label wins across every border, until no rank changes one.
void joinAcrossRanks(MeshGraph const& graph, std::vector<char> const& wet,
                     std::vector<int> const& body, std::vector<int>& label) {
  for (int changed = 1; changed;) {
    Eigen::MatrixXd mine(1, graph.cells());
    for (int cell = 0; cell < graph.cells(); ++cell)
      mine(0, cell) = wet[cell] ? label[body[cell]] : -1;
    auto const theirs = graph.across(mine);
    changed = 0;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
      for (long face = 0; face < theirs[i].cols(); ++face) {
        int const cell = graph.borders[i].cells[face];
        int const other = static_cast<int>(theirs[i](0, face));
        if (!wet[cell] || other < 0 || other >= label[body[cell]]) continue;
        label[body[cell]] = other;
        changed = 1;
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, &changed, 1, MPI_INT, MPI_MAX, graph.comm);
  }
}

}  // namespace

std::vector<char> largeBodies(MeshGraph const& graph, std::vector<char> const& wet,
                              Eigen::MatrixXd const& amount, double share) {
  std::vector<int> const body = bodiesOfRank(graph, wet);
  std::vector<int> roots;
  for (int cell = 0; cell < graph.cells(); ++cell) {
    if (wet[cell] && body[cell] == cell) roots.push_back(cell);
  }
  int const count = static_cast<int>(roots.size());
  int end = 0, total = 0;
  MPI_Scan(&count, &end, 1, MPI_INT, MPI_SUM, graph.comm);
  MPI_Allreduce(&count, &total, 1, MPI_INT, MPI_SUM, graph.comm);
  std::vector<char> chosen(graph.cells(), 0);
  if (total == 0) return chosen;

  std::vector<int> label(graph.cells(), -1);  // of the cell that stands for a body
  for (int i = 0; i < count; ++i) label[roots[i]] = end - count + i;
  joinAcrossRanks(graph, wet, body, label);
  std::vector<double> sum(total, 0.0);  // a number a body, not a cell
  for (int cell = 0; cell < graph.cells(); ++cell) {
    if (wet[cell]) sum[label[body[cell]]] += amount(0, cell);
  }
  MPI_Allreduce(MPI_IN_PLACE, sum.data(), total, MPI_DOUBLE, MPI_SUM, graph.comm);
  double const enough = share * std::accumulate(sum.begin(), sum.end(), 0.0);
  for (int cell = 0; cell < graph.cells(); ++cell) {
    chosen[cell] = wet[cell] && sum[label[body[cell]]] >= enough;
  }
  return chosen;
}

}  // namespace slidewave::foam
