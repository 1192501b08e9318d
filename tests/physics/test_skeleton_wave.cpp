// One wave of a particle skeleton under an added mass that acts a window late: the exact map from
// window to window, and the largest factor by which it grows.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "slidewave/physics/limits/concurrent.hpp"
#include "slidewave/physics/limits/contact_step.hpp"
#include "slidewave/physics/limits/skeleton_wave.hpp"

namespace slidewave {
namespace {

/// y'' = -w^2 y - S a_late with W = 1, a_late the second difference of the last three window ends;
/// one window `older` in the concurrent scheme.
double growth(double w, double added_mass_number, bool older = false) {
  double const from_force = (1 - std::cos(w)) / (w * w);
  Eigen::RowVectorXd late(5);  // of (y_n, v_n, y_(n-1), y_(n-2), y_(n-3))
  late << (older ? Eigen::RowVectorXd{{0, 0, 1, -2, 1}} : Eigen::RowVectorXd{{1, 0, -2, 1, 0}});
  late *= -added_mass_number;
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(5, 5);
  map.row(0) = from_force * late;
  map.row(1) = std::sin(w) / w * late;
  map(0, 0) += std::cos(w);
  map(0, 1) += std::sin(w) / w;
  map(1, 0) += -w * std::sin(w);
  map(1, 1) += std::cos(w);
  map(2, 0) = map(3, 2) = map(4, 3) = 1;
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(SkeletonWave, WavesWithinTheComfortableRunAreDamped) {
  for (double const s : {0.05, 0.15, 0.57, 0.9}) {
    double const comfort = limits::comfortable_wave_share * limits::largest_wave_run(s);
    for (double w = 0.05; w <= comfort; w += 0.05) {
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

TEST(SkeletonWave, ConcurrentlyTheyAreFedEarlier) {
  for (double const s : {0.05, 0.15, 0.3, limits::concurrent_added_mass_number}) {
    for (double w = 0.05; w <= limits::comfortable_concurrent_wave_run; w += 0.05) {
      EXPECT_LE(growth(w, s, true), 1 + 1e-9) << w << " " << s;
    }
  }
  for (auto const& [s, w] : {std::pair(1.0, 0.56), {0.57, 0.94}, {0.05, 1.24}}) {
    EXPECT_LE(growth(w - 0.02, s, true), 1 + 1e-9) << s;
    EXPECT_GT(growth(w + 0.02, s, true), 1) << s;
  }
  // Long waves show the limit of the added mass itself.
  EXPECT_LT(growth(0.01, 1.2, true), 1);
  EXPECT_GT(growth(0.01, 1.3, true), 1);
  EXPECT_LT(growth(0.01, 1.95), 1);
  EXPECT_GT(growth(0.01, 2.05), 1);
}

TEST(SkeletonWave, LimitLiesBetweenWhatRanAndWhatGrew) {
  // Undamped piles with both engines (docs/stability.md): S, c W/L that ran, c W/L that grew.
  for (auto const& [s, ran, grew] :
       {std::array{1.05, 1.9, 3.0}, {1.37, 1.45, 9.0}, {2.31, 0.8, 1.1}}) {
    EXPECT_LE(ran, limits::largest_wave_run(s) * 1.0001) << s;
    EXPECT_GT(grew, limits::largest_wave_run(s)) << s;
  }
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
