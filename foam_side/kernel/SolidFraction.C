#include "SolidFraction.H"

namespace slidewave::foam {

void SolidFraction::deposit(ParticleKernel& kernel, Table::ConstColumn volume_m3) {
  store(kernel, kernel.spread(1, [&](int i, double* out) { *out = volume_m3(0, i); }), 0);
}

void SolidFraction::store(ParticleKernel const& kernel, ParticleKernel::Fields const& spread,
                          int row) {
  deposit_.resize(static_cast<std::size_t>(spread.cols()));
  for (long cell = 0; cell < spread.cols(); ++cell) deposit_[cell] = spread(row, cell);
  stored_ = deposit_;
  moved_m3_ = kernel.smoother().spreadExcess(stored_, 1 - smallest_void_fraction);
}

double SolidFraction::volume_m3(ParticleKernel const& kernel) const {
  auto const& volume_m3 = kernel.smoother().graph().volume_m3;
  double sum = 0;
  for (std::size_t cell = 0; cell < stored_.size(); ++cell) sum += stored_[cell] * volume_m3[cell];
  return sum;
}

Vec3 SolidFraction::integrate(ParticleKernel const& kernel, Table::ConstColumn field) const {
  auto const& volume_m3 = kernel.smoother().graph().volume_m3;
  Vec3 sum = Vec3::Zero();
  for (std::size_t cell = 0; cell < deposit_.size(); ++cell) {
    sum += deposit_[cell] * volume_m3[cell] * field.col(static_cast<long>(cell));
  }
  return sum;
}

}  // namespace slidewave::foam
