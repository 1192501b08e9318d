#include "SolidFraction.H"

namespace slidewave::foam {

void SolidFraction::deposit(ParticleKernel const& kernel, Eigen::MatrixXd const& volume_m3) {
  deposit_ = kernel.spread(volume_m3);
  stored_ = deposit_;
  moved_m3_ = kernel.smoother().spreadExcess(stored_, 1 - smallest_void_fraction);
}

Eigen::MatrixXd SolidFraction::voidFraction() const {
  return (1 - stored_.array()).max(smallest_void_fraction);
}

double SolidFraction::volume_m3(ParticleKernel const& kernel) const {
  auto const& volume_m3 = kernel.smoother().graph().volume_m3;
  double sum = 0;
  for (long cell = 0; cell < stored_.cols(); ++cell) sum += stored_(0, cell) * volume_m3[cell];
  return sum;
}

Vec3 SolidFraction::integrate(ParticleKernel const& kernel, Eigen::MatrixXd const& field) const {
  auto const& volume_m3 = kernel.smoother().graph().volume_m3;
  Vec3 sum = Vec3::Zero();
  for (long cell = 0; cell < deposit_.cols(); ++cell) {
    sum += deposit_(0, cell) * volume_m3[cell] * field.col(cell);
  }
  return sum;
}

}  // namespace slidewave::foam
