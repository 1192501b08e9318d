#include <algorithm>

#include "ParticleKernel.H"

namespace slidewave::foam {

// A counting sort by cell.
void ParticleKernel::place(Table::ConstColumn position_m,
                           std::vector<int> const& cell_of_particle) {
  position_m_ = position_m.data();
  first_.assign(stencil_.cells() + 1, 0);
  for (int const cell : cell_of_particle) ++first_[cell];
  int sum = 0;
  for (int& first : first_) first = sum += first;  // the end of each cell
  order_.resize(cell_of_particle.size());
  for (std::size_t i = cell_of_particle.size(); i-- > 0;) {
    order_[--first_[cell_of_particle[i]]] = static_cast<int>(i);
  }
}

void ParticleKernel::weigh(int cell, int const* particles, int count) {
  double points_m[3 * lanes];
  for (int l = 0; l < lanes; ++l) {
    double const* const at = position_m_ + 3L * particles[std::min(l, count - 1)];
    for (int d = 0; d < 3; ++d) points_m[lanes * d + l] = at[d];
  }
  stencil_.weigh(cell, count, points_m, block_);
}

ParticleKernel::Fields ParticleKernel::clear(int components) {
  components_ = padded(components);
  int const columns = std::max(smoother_.columns(), stencil_.columns());
  values_.assign(static_cast<std::size_t>(columns) * components_, 0.0);
  return {values_.data(), components_, stencil_.cells()};
}

ParticleKernel::Fields ParticleKernel::fields(int components) {
  return clear(components);
}

ParticleKernel::Fields ParticleKernel::finishSpread() {
  stencil_.collect(values_.data(), components_);
  auto const& volume_m3 = smoother_.graph().volume_m3;
  Fields density(values_.data(), components_, stencil_.cells());
  for (int cell = 0; cell < stencil_.cells(); ++cell) density.col(cell) /= volume_m3[cell];
  smoother_.smooth(values_, spare_, components_);
  return {values_.data(), components_, stencil_.cells()};
}

}  // namespace slidewave::foam
