#include "SolidFraction.H"

namespace slidewave::foam {

void SolidFraction::deposit(ParticleKernel& kernel, Table::ConstColumn volume_m3) {
  auto const fraction =
      kernel.spread(1, [&](int particle, double* out) { *out = volume_m3(0, particle); });
  deposit_.assign(fraction.data(), fraction.data() + fraction.size());
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
