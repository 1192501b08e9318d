#include <algorithm>
#include <stdexcept>

#include "ParticleKernel.H"

namespace slidewave::foam {

long ParticleKernel::place(Table::ConstColumn position_m,
                           std::vector<int> const& cell_of_particle) {
  if (!std::is_sorted(cell_of_particle.begin(), cell_of_particle.end())) {
    throw std::invalid_argument("slidewave_foam: particles must come sorted by cell");
  }
  position_m_ = position_m.data();
  particles_ = static_cast<int>(cell_of_particle.size());
  first_.assign(stencil_.cells() + 1, 0);
  for (int const cell : cell_of_particle) ++first_[cell + 1];
  for (int cell = 0; cell < stencil_.cells(); ++cell) first_[cell + 1] += first_[cell];
  long counts[2] = {particles_, near_.strangers(first_)};
  MPI_Allreduce(MPI_IN_PLACE, counts, 2, MPI_LONG, MPI_SUM, smoother_.graph().comm);
  if (counts[1] > 0) near_.find(first_, smoother_, stencil_, amounts_, spare_);
  return counts[0];
}

void ParticleKernel::weigh(int cell, Block const& block) const {
  double points_m[3 * lanes];
  for (int l = 0; l < lanes; ++l) {
    double const* const at = position_m_ + 3L * (block.first + std::min(l, block.count - 1));
    for (int d = 0; d < 3; ++d) points_m[lanes * d + l] = at[d];
  }
  stencil_.weigh(cell, block.count, points_m, block.weights);
}

ParticleKernel::Fields ParticleKernel::clear(CellValues& values, int components) const {
  int const columns = std::max(smoother_.columns(), stencil_.columns());
  values.assign(static_cast<std::size_t>(columns) * padded(components), 0.0);
  return {values.data(), padded(components), stencil_.cells()};
}

ParticleKernel::Fields ParticleKernel::fields(int components) {
  field_components_ = padded(components);
  return clear(fields_, components);
}

void ParticleKernel::beginGather() {
  near_.gather(smoother_, fields_, spare_, field_components_);
  stencil_.fetch(fields_.data(), field_components_);
}

ParticleKernel::Fields ParticleKernel::finishSpread(int components) {
  stencil_.collect(amounts_.data(), components);
  auto const& volume_m3 = smoother_.graph().volume_m3;
  Fields density(amounts_.data(), components, stencil_.cells());
  for (int cell = 0; cell < stencil_.cells(); ++cell) density.col(cell) /= volume_m3[cell];
  near_.spread(smoother_, amounts_, spare_, components);
  return {amounts_.data(), components, stencil_.cells()};
}

}  // namespace slidewave::foam
