#include "ParticleKernel.H"

namespace slidewave::foam {

Eigen::MatrixXd ParticleKernel::spread(Eigen::MatrixXd const& amounts) const {
  auto const& volume_m3 = smoother_.graph().volume_m3;
  Eigen::MatrixXd density = Eigen::MatrixXd::Zero(amounts.rows(), smoother_.graph().cells());
  for (int i = 0; i < particles(); ++i)
    density.col(cell_[i]) += amounts.col(i) / volume_m3[cell_[i]];
  smoother_.smooth(density);
  return density;
}

Eigen::MatrixXd ParticleKernel::gather(Eigen::MatrixXd field) const {
  smoother_.smooth(field);
  Eigen::MatrixXd values(field.rows(), particles());
  for (int i = 0; i < particles(); ++i) values.col(i) = field.col(cell_[i]);
  return values;
}

}  // namespace slidewave::foam
