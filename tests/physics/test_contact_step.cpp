// The critical step against the true fastest mode of sphere lattices, found by a sweep of waves.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <vector>

#include "slidewave/physics/limits/contact_step.hpp"
#include "slidewave/physics/limits/overlap.hpp"

namespace slidewave {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6 = Eigen::Matrix<std::complex<double>, 6, 6>;

// Half of the neighbours of a sphere (the other half are their opposites), in lattice units whose
// waves repeat after 2 pi in each coordinate.
std::vector<Vector3d> const simple_cubic{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
std::vector<Vector3d> const face_centred{{1, 1, 0},  {1, -1, 0}, {1, 0, 1},
                                         {1, 0, -1}, {0, 1, 1},  {0, 1, -1}};

/// Largest w^2 m of all waves: each contact joins (u, spin) of a sphere and of its neighbour, the
/// same but for a phase; slip at the contact is u_j - u_i - r (spin_i + spin_j) x n.
double fastest_mode(std::vector<Vector3d> const& half_neighbours, double kn, double ks) {
  double fastest = 0;
  int const n = 8;
  for (int a = 0; a <= n; ++a) {
    for (int b = 0; b <= n; ++b) {
      for (int c = 0; c <= n; ++c) {
        Vector3d const wave = 2 * M_PI / n * Vector3d(a, b, c);
        Matrix6 stiffness = Matrix6::Zero();
        for (auto const& neighbour : half_neighbours) {
          Vector3d const normal = neighbour.normalized();
          std::complex<double> const phase = std::polar(1.0, wave.dot(neighbour));
          Matrix3d cross;  // cross * spin = -(spin x normal)
          cross << 0, -normal(2), normal(1), normal(2), 0, -normal(0), -normal(1), normal(0), 0;
          Eigen::Matrix<std::complex<double>, 3, 6> slip;
          slip << (phase - 1.0) * Matrix3d::Identity(), (phase + 1.0) * cross;
          Matrix3d const along = normal * normal.transpose();
          Matrix3d const spring = kn * along + ks * (Matrix3d::Identity() - along);
          stiffness += slip.adjoint() * spring * slip;
        }
        Eigen::Matrix<double, 6, 1> scale;  // 1/sqrt(m), 1/sqrt(2/5 m r^2) with m = r = 1
        scale << 1, 1, 1, std::sqrt(2.5), std::sqrt(2.5), std::sqrt(2.5);
        Matrix6 const modes = scale.asDiagonal() * stiffness * scale.asDiagonal();
        Eigen::SelfAdjointEigenSolver<Matrix6> const solver(modes, Eigen::EigenvaluesOnly);
        fastest = std::max(fastest, solver.eigenvalues()(5));
      }
    }
  }
  return fastest;
}

double ratio_to_lattice(std::vector<Vector3d> const& half, double kn, double ks) {
  double const exact = 2 / std::sqrt(fastest_mode(half, kn, ks));
  return limits::critical_contact_step(1, kn, ks, 2.0 * double(half.size())) / exact;
}

TEST(ContactStep, ExactForSimpleCubicLattice) {
  EXPECT_NEAR(ratio_to_lattice(simple_cubic, 3, 0), 1, 1e-12);
  EXPECT_NEAR(ratio_to_lattice(simple_cubic, 3, 1), 1, 1e-12);
  EXPECT_NEAR(ratio_to_lattice(simple_cubic, 3, 2.7), 1, 1e-12);
}

TEST(ContactStep, NeverBeyondFaceCentredLattice) {
  EXPECT_NEAR(ratio_to_lattice(face_centred, 3, 0), 1, 1e-12);
  for (double const ks : {0.5, 1.0, 2.0, 2.7}) {
    double const ratio = ratio_to_lattice(face_centred, 3, ks);
    EXPECT_LE(ratio, 1 + 1e-12) << ks;
    EXPECT_GT(ratio, 0.7) << ks;
  }
}

TEST(ContactStep, SmallestVajontGrain) {
  // D 1.8 m, 2650 kg/m3, kn 3e9 (PHYSICS.md 0.6): sqrt(m/kn) 1.64e-3 s, contact time 3.65e-3 s.
  double const mass = 2650 * M_PI / 6 * std::pow(1.8, 3);
  EXPECT_NEAR(limits::contact_time(mass, 3e9), 3.65e-3, 0.01e-3);
  EXPECT_NEAR(limits::critical_contact_step(mass, 3e9, 2.7e9) / 1.64e-3, 0.516, 0.002);
}

TEST(Overlap, OfAColumnAndOfACollision) {
  // 200 m of rock at porosity 0.40, kn 3e9 (PHYSICS.md 1.6): 0.19, 0.29, 0.40 % of D.
  for (auto const& row : {Vector3d(1.8, 0.19, 0), Vector3d(2.8, 0.29, 0), Vector3d(3.8, 0.40, 0)}) {
    EXPECT_NEAR(100 * limits::static_overlap(200, 2650 * 0.60, 9.81, row(0), 3e9), row(1), 0.006);
  }
  // A collision integrated step by step.
  double const mass = 5e4, kn = 3e9, diameter = 3;
  double gap = 0, speed = 12, deepest = 0;
  for (double const dt = 1e-6; gap >= 0; gap += dt * speed) {
    speed -= dt * 2 * kn * gap / mass;
    deepest = std::max(deepest, gap);
  }
  EXPECT_NEAR(limits::impact_overlap(12, mass, diameter, kn) * diameter / deepest, 1, 1e-3);
  double const stiffer = limits::stiffness_for_impact(0.2, 0.1, kn);
  EXPECT_NEAR(limits::impact_overlap(12, mass, diameter, stiffer),
              limits::impact_overlap(12, mass, diameter, kn) / 2, 1e-12);
}

}  // namespace
}  // namespace slidewave
