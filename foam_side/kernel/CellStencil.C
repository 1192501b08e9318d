#include <algorithm>
#include <numeric>

#include "CellStencil.H"

namespace slidewave::foam {

CellStencil::CellStencil(int cells) : cells_(cells), first_(cells + 1), columns_(cells) {
  std::iota(first_.begin(), first_.end(), 0);
  std::iota(columns_.begin(), columns_.end(), 0);
}

CellStencil::CellStencil(std::vector<CellShape> const& shapes, Vec3 const& period_m, MPI_Comm comm)
    : cells_(static_cast<int>(shapes.size())), comm_(comm) {
  std::vector<Vec3> reach_m;
  collectCentres(shapes, period_m, comm, reach_m);
  findNeighbours(shapes, reach_m);
  for (int const centre : near_) columns_.push_back(column_[centre]);
  for (int cell = 0; cell < cells_; ++cell) {
    auto const begin = near_.begin() + first_[cell], end = near_.begin() + first_[cell + 1];
    own_.push_back(static_cast<int>(std::lower_bound(begin, end, cell) - begin));
    largest_ = std::max(largest_, static_cast<int>(end - begin));
  }
}

void CellStencil::weigh(int cell, int active, double const* points_m, double* weights) const {
  if (!isSpline()) {
    std::fill_n(weights, active, 1.0);
    return;
  }
  auto const weigh = upright_ ? laneLoops().uprightWeights : laneLoops().weights;
  weigh(centres_.data(), near_.data() + first_[cell], around(cell).count, own_[cell], active,
        points_m, weights);
}

void CellStencil::fetch(double* values, int components) const {
  requests_.clear();
  for (Border const& border : borders_) {
    std::size_t const size = border.ours.size() * components;
    border.message.resize(std::max(border.message.size(), size));
    double* out = border.message.data();
    for (int const cell : border.ours) {
      out = std::copy_n(values + static_cast<long>(cell) * components, components, out);
    }
    requests_.resize(requests_.size() + 2);
    MPI_Irecv(values + static_cast<long>(border.first) * components, border.count * components,
              MPI_DOUBLE, border.rank, 0, comm_, &requests_.end()[-2]);
    MPI_Isend(border.message.data(), static_cast<int>(size), MPI_DOUBLE, border.rank, 0, comm_,
              &requests_.end()[-1]);
  }
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
}

void CellStencil::collect(double* values, int components) const {
  requests_.clear();
  for (Border const& border : borders_) {
    std::size_t const size = border.ours.size() * components;
    border.message.resize(std::max(border.message.size(), size));
    requests_.resize(requests_.size() + 2);
    MPI_Irecv(border.message.data(), static_cast<int>(size), MPI_DOUBLE, border.rank, 1, comm_,
              &requests_.end()[-2]);
    MPI_Isend(values + static_cast<long>(border.first) * components, border.count * components,
              MPI_DOUBLE, border.rank, 1, comm_, &requests_.end()[-1]);
  }
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  for (Border const& border : borders_) {
    double const* in = border.message.data();
    for (int const cell : border.ours) {
      double* const own = values + static_cast<long>(cell) * components;
      for (int c = 0; c < components; ++c) own[c] += *in++;
    }
  }
}

}  // namespace slidewave::foam
