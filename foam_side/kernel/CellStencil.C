#include <algorithm>

#include "CellStencil.H"

namespace slidewave::foam {

CellStencil::CellStencil(std::vector<CellShape> const& shapes, Vec3 const& period_m, MPI_Comm comm)
    : cells_(static_cast<int>(shapes.size())), comm_(comm) {
  std::vector<Vec3> reach_m;
  collectCentres(shapes, period_m, comm, reach_m);
  findNeighbours(shapes, reach_m);
}

void CellStencil::begin(int cell, Block& block) const {
  block.count = isSpline() ? first_[cell + 1] - first_[cell] : 1;
  block.weights.resize(
      std::max(block.weights.size(), static_cast<std::size_t>(lanes) * block.count));
  block.room.resize(std::max<std::size_t>(block.room.size(), block.count));
  block.own = 0;
  block.room[0] = cell;
  block.columns = block.room.data();
  if (!isSpline()) return;
  int const* const near = near_.data() + first_[cell];
  block.own = static_cast<int>(std::lower_bound(near, near + block.count, cell) - near);
  if (static_cast<int>(centres_.size()) == cells_) {  // all are own cells
    block.columns = near;
    return;
  }
  for (int k = 0; k < block.count; ++k) block.room[k] = column_[near[k]];
}

void CellStencil::weigh(int cell, int active, double const* points_m, Block& block) const {
  if (!isSpline()) {
    std::fill_n(block.weights.begin(), active, 1.0);
    return;
  }
  auto const weights = upright_ ? laneLoops().uprightWeights : laneLoops().weights;
  weights(centres_.data(), near_.data() + first_[cell], block.count, block.own, active, points_m,
          block.weights.data());
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
