#include <algorithm>
#include <cmath>

#include "Smoother.H"

namespace slidewave::foam {
namespace {

// Largest rate at which a cell exchanges with its neighbours [1/m2], over all ranks.
double largestRate(MeshGraph const& graph) {
  std::vector<double> rate(graph.volume_m3.size());
  for (auto const& link : graph.links) {
    rate[link.a] += link.conductance;
    rate[link.b] += link.conductance;
  }
  for (auto const& border : graph.borders) {
    for (std::size_t i = 0; i < border.cells.size(); ++i) {
      rate[border.cells[i]] += border.conductance[i];
    }
  }
  double largest = 0;
  for (int cell = 0; cell < graph.cells(); ++cell) {
    largest = std::max(largest, rate[cell] / graph.volume_m3[cell]);
  }
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, graph.comm);
  return largest;
}

}  // namespace

Smoother::Smoother(MeshGraph graph, double length_m) : graph_(std::move(graph)) {
  // Diffusion over pseudo-time t widens a point to exp(-r^2/(4 t)).
  double const total_m2 = length_m * length_m / 4;
  double const rate = largestRate(graph_);
  // A cell keeps at least half of its value in a step; a weaker step than that also serves to
  // spread excess where nothing is to be smoothed.
  steps_ = static_cast<int>(std::ceil(2 * rate * total_m2));
  pseudo_time_m2_ = steps_ > 0 ? total_m2 / steps_ : 0.5 / std::max(rate, 1e-300);
}

// With the number of components known at compile time a face costs a few instructions.
template <int Components>
void Smoother::stepOf(Eigen::MatrixXd& all) const {
  using Values = Eigen::Matrix<double, Components, Eigen::Dynamic>;
  auto const neighbours = graph_.across(all);
  Eigen::Map<Values> values(all.data(), all.rows(), all.cols());
  Values change = Values::Zero(all.rows(), all.cols());
  for (auto const& link : graph_.links) {
    auto const flow = (link.conductance * (values.col(link.b) - values.col(link.a))).eval();
    change.col(link.a) += flow;
    change.col(link.b) -= flow;
  }
  for (std::size_t i = 0; i < graph_.borders.size(); ++i) {
    auto const& border = graph_.borders[i];
    for (std::size_t face = 0; face < border.cells.size(); ++face) {
      int const cell = border.cells[face];
      change.col(cell) += border.conductance[face] *
                          (neighbours[i].col(static_cast<long>(face)) - values.col(cell));
    }
  }
  for (int cell = 0; cell < graph_.cells(); ++cell) {
    values.col(cell) += pseudo_time_m2_ / graph_.volume_m3[cell] * change.col(cell);
  }
}

void Smoother::step(Eigen::MatrixXd& values) const {
  switch (values.rows()) {
    case 1:
      return stepOf<1>(values);
    case 3:
      return stepOf<3>(values);
    case 7:
      return stepOf<7>(values);
    default:
      return stepOf<Eigen::Dynamic>(values);
  }
}

void Smoother::smooth(Eigen::MatrixXd& values) const {
  for (int i = 0; i < steps_; ++i) step(values);
}

double Smoother::spreadExcess(Eigen::MatrixXd& values, double limit, int passes) const {
  double moved_m3 = 0;
  for (int pass = 0; pass < passes; ++pass) {
    Eigen::MatrixXd excess = (values.array() - limit).max(0.0);
    double volume_m3 = 0;
    for (int cell = 0; cell < graph_.cells(); ++cell) {
      volume_m3 += excess.col(cell).sum() * graph_.volume_m3[cell];
    }
    MPI_Allreduce(MPI_IN_PLACE, &volume_m3, 1, MPI_DOUBLE, MPI_SUM, graph_.comm);
    if (volume_m3 == 0) break;
    moved_m3 = std::max(moved_m3, volume_m3);
    values -= excess;
    step(excess);
    values += excess;
  }
  return moved_m3;
}

}  // namespace slidewave::foam
