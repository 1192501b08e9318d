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

Smoother::Smoother(MeshGraph graph, double length_m)
    : graph_(std::move(graph)), everywhere_{{0, graph_.cells()}} {
  // Diffusion over pseudo-time t widens a point to exp(-r^2/(4 t)).
  double const total_m2 = length_m * length_m / 4;
  double const rate = largestRate(graph_);
  // A cell keeps at least half of its value in a step; a weaker step than that also serves to
  // spread excess where nothing is to be smoothed.
  steps_ = static_cast<int>(std::ceil(2 * rate * total_m2));
  pseudo_time_m2_ = steps_ > 0 ? total_m2 / steps_ : 0.5 / std::max(rate, 1e-300);
  listPulls();
}

// What each cell takes from which neighbour, row by row.
void Smoother::listPulls() {
  columns_ = graph_.cells();
  first_.assign(graph_.cells() + 1, 0);
  auto const forAll = [this](auto const& visit) {
    for (MeshGraph::Link const& link : graph_.links) {
      visit(link.a, link.b, link.conductance);
      visit(link.b, link.a, link.conductance);
    }
    int column = graph_.cells();
    for (MeshGraph::Border const& border : graph_.borders) {
      for (std::size_t i = 0; i < border.cells.size(); ++i) {
        visit(border.cells[i], column++, border.conductance[i]);
      }
    }
    columns_ = column;
  };
  forAll([this](int cell, int, double) { ++first_[cell + 1]; });
  for (int cell = 0; cell < graph_.cells(); ++cell) first_[cell + 1] += first_[cell];
  pulls_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end());
  forAll([&](int cell, int column, double conductance) {
    pulls_[next[cell]++] = {column, conductance * pseudo_time_m2_ / graph_.volume_m3[cell]};
  });
  messages_.resize(graph_.borders.size());
}

void Smoother::fillBorders(double* values, int components) const {
  requests_.resize(2 * graph_.borders.size());
  double* in = values + static_cast<long>(graph_.cells()) * components;
  for (std::size_t b = 0; b < graph_.borders.size(); ++b) {
    MeshGraph::Border const& border = graph_.borders[b];
    int const size = static_cast<int>(border.cells.size()) * components;
    messages_[b].resize(std::max<std::size_t>(messages_[b].size(), size));
    double* out = messages_[b].data();
    for (int const cell : border.cells) {
      out = std::copy_n(values + static_cast<long>(cell) * components, components, out);
    }
    MPI_Irecv(in, size, MPI_DOUBLE, border.rank, border.tag, graph_.comm, &requests_[2 * b]);
    MPI_Isend(messages_[b].data(), size, MPI_DOUBLE, border.rank, border.tag, graph_.comm,
              &requests_[2 * b + 1]);
    in += size;
  }
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
}

void Smoother::step(CellValues& values, CellValues& spare, int components,
                    CellRuns const& cells) const {
  spare.resize(values.size());
  fillBorders(values.data(), components);
  for (CellRun const run : cells) {
    laneLoops().pull(pulls_.data(), first_.data(), run, values.data(), components, spare.data());
  }
  values.swap(spare);
}

double Smoother::spreadExcess(CellValues& values, double limit, int passes) const {
  double moved_m3 = 0;
  excess_.resize(columns_);
  for (int pass = 0; pass < passes; ++pass) {
    double volume_m3 = 0;
    for (int cell = 0; cell < graph_.cells(); ++cell) {
      excess_[cell] = std::max(values[cell] - limit, 0.0);
      volume_m3 += excess_[cell] * graph_.volume_m3[cell];
    }
    MPI_Allreduce(MPI_IN_PLACE, &volume_m3, 1, MPI_DOUBLE, MPI_SUM, graph_.comm);
    if (volume_m3 == 0) break;
    moved_m3 = std::max(moved_m3, volume_m3);
    for (int cell = 0; cell < graph_.cells(); ++cell) values[cell] -= excess_[cell];
    step(excess_, spare_, 1, everywhere_);
    for (int cell = 0; cell < graph_.cells(); ++cell) values[cell] += excess_[cell];
  }
  return moved_m3;
}

}  // namespace slidewave::foam
