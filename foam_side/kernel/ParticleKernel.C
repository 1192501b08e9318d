#include "ParticleKernel.H"

namespace slidewave::foam {

void ParticleKernel::place(Table::ConstColumn position_m,
                           std::vector<int> const& cell_of_particle) {
  shares_.clear();
  first_.assign(1, 0);
  for (std::size_t i = 0; i < cell_of_particle.size(); ++i) {
    stencil_.shares(position_m.col(static_cast<long>(i)), cell_of_particle[i], shares_);
    first_.push_back(shares_.size());
  }
}

Eigen::MatrixXd ParticleKernel::spread(Eigen::MatrixXd const& amounts) const {
  auto const& volume_m3 = smoother_.graph().volume_m3;
  Eigen::MatrixXd density = Eigen::MatrixXd::Zero(amounts.rows(), stencil_.columns());
  for (int i = 0; i < particles(); ++i) {
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      density.col(shares_[k].cell) += shares_[k].weight * amounts.col(i);
    }
  }
  density = stencil_.collected(density);
  for (int cell = 0; cell < stencil_.cells(); ++cell) density.col(cell) /= volume_m3[cell];
  smoother_.smooth(density);
  return density;
}

Eigen::MatrixXd ParticleKernel::gather(Eigen::MatrixXd field) const {
  smoother_.smooth(field);
  field = stencil_.withOthers(field);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(field.rows(), particles());
  for (int i = 0; i < particles(); ++i) {
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      values.col(i) += shares_[k].weight * field.col(shares_[k].cell);
    }
  }
  return values;
}

}  // namespace slidewave::foam
