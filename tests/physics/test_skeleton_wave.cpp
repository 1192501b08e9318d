// One wave of a particle skeleton under an added mass that acts a window late: the exact map from
// window to window, and the largest factor by which it grows.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "slidewave/physics/limits/contact_step.hpp"
#include "slidewave/physics/limits/skeleton_wave.hpp"

namespace slidewave {
namespace {

/// y'' = -w^2 y - S a_late with W = 1, a_late = y_n - 2 y_(n-1) + y_(n-2) of the window ends.
double growth(double w, double added_mass_number) {
  double const from_force = (1 - std::cos(w)) / (w * w);
  Eigen::RowVector4d const late = -added_mass_number * Eigen::RowVector4d(1, 0, -2, 1);
  Eigen::Matrix4d map = Eigen::Matrix4d::Zero();  // of (y_n, v_n, y_(n-1), y_(n-2))
  map.row(0) = Eigen::RowVector4d(std::cos(w), std::sin(w) / w, 0, 0) + from_force * late;
  map.row(1) = Eigen::RowVector4d(-w * std::sin(w), std::cos(w), 0, 0) + std::sin(w) / w * late;
  map(2, 0) = 1;
  map(3, 2) = 1;
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(SkeletonWave, WavesWithinTheComfortableRunAreDamped) {
  for (double const s : {0.05, 0.15, 0.57, 0.9}) {
    for (double w = 0.05; w <= limits::comfortable_wave_run; w += 0.05) {
      EXPECT_LE(growth(w, s), 1 + 1e-9) << w << " " << s;
    }
  }
}

TEST(SkeletonWave, FasterOnesAreFed) {
  for (double const w : {2.2, 3.0, 4.0}) {
    EXPECT_GT(growth(w, 0.57), 1.02) << w;
  }
  EXPECT_LT(growth(3, 1e-3), 1.001);  // air
}

TEST(SkeletonWave, SpeedOfAChain) {
  // Long waves of a chain: w = 2 sqrt(kn/m) sin(k d/2) -> c k.
  double const d = 3.6, m = 6.5e4, kn = 3e9, k = 1e-3;
  EXPECT_NEAR(limits::skeleton_wave_speed(d, m, kn),
              2 * std::sqrt(kn / m) * std::sin(k * d / 2) / k, 1e-3);
  EXPECT_NEAR(limits::wave_run(800, 0.02, 16), 1, 1e-12);
}

}  // namespace
}  // namespace slidewave
