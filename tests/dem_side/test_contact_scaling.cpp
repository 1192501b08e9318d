// Coarse-grain scaling of contacts: where dimensional analysis says so, the particles move as the
// grains do. Lengths of a scene without weight are scaled by alpha. K ~ D: times scale by alpha,
// speeds stay. Sakai: a particle and its grains have the same displacements in the same time.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "contact_scale.h"
#include "pair_style.h"
#include "slidewave/physics/drag_models.hpp"
#include "slidewave/physics/volume_forces.hpp"
#include "small_scene.h"

namespace {

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.17g", value);
  return buffer;
}

struct End {
  std::array<double, 3> velocity{};
  std::array<double, 3> spin{};
  double offset = 0;  // between the spheres along x [m]
};

// An oblique impact of two spinning spheres of 0.2 m times `size`, and the bounce of the first on a
// wall, with every law at work; `duration` times 0.06 s.
End impact(slidewave::ContactScale scale, double size, double duration, double gap, double spin) {
  slidewave::dem::contact_scale() = scale;
  SmallScene scene;
  scene.box("f f f");
  std::string const law =
      "model linear kn 1e6 damping 0.1 tangential coulomb ks 8e5 mu 0.4 damping_s 0.05 "
      "rolling_friction iwashita_oda kr 500 eta 0.3";
  scene.law(law);
  scene.wall("side", law, "primitive type 1 xplane 4");
  double const radius = 0.1 * size;
  scene.sphere(4 + radius + gap, 5, 5, 2 * radius);
  scene.sphere(4 + 3 * radius + 2 * gap, 5 + 0.5 * radius, 5, 2 * radius);
  scene.set_velocity(1, "1 0.5 0");
  scene.set_velocity(2, "-1 0 0.2");
  scene.set_spin(1, 0, 3 * spin, 5 * spin);
  scene.set_spin(2, 2 * spin, 0, -1 * spin);
  int const steps = 6000;
  scene.lines({"fix integrate all nve/sphere", "timestep " + text(0.06 * duration / steps),
               "run " + std::to_string(steps)});
  End end;
  for (int axis = 0; axis < 3; ++axis) {
    end.velocity[static_cast<std::size_t>(axis)] = scene.v(1, axis);
    end.spin[static_cast<std::size_t>(axis)] = scene.omega(1, axis) / spin;
  }
  end.offset = scene.x(2, 0) - scene.x(1, 0);
  slidewave::dem::contact_scale() = {};
  return end;
}

void expect_same(End const& particle, End const& grain, double tolerance) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(particle.velocity[axis], grain.velocity[axis], tolerance) << axis;
    EXPECT_NEAR(particle.spin[axis], grain.spin[axis], tolerance) << axis;
  }
}

// Geometry, gaps and all: speeds are the same, spins go with 1/alpha, times with alpha.
TEST(Scaling, ProportionalKeepsTheDimensionlessTrajectory) {
  using slidewave::ContactScaling;
  End const grain = impact({}, 1, 1, 0.001, 1);
  EXPECT_GT(grain.velocity[0], 0.2) << "bounced off the wall";
  for (double const alpha : {2.0, 4.0}) {
    End const particle = impact(slidewave::contact_scale(ContactScaling::proportional, alpha),
                                alpha, alpha, 0.001 * alpha, 1 / alpha);
    expect_same(particle, grain, 1e-9);
    EXPECT_NEAR(particle.offset, alpha * grain.offset, 1e-9);
  }
}

// The same overlap at every moment. Head-on, since the sizes themselves enter where the contact
// turns: gaps and times are those of the grains.
TEST(Scaling, SakaiKeepsDisplacementsAndTimes) {
  double overlap[2];
  double exit_speed[2];
  for (int coarse = 0; coarse < 2; ++coarse) {
    double const alpha = coarse ? 5 : 1;
    slidewave::dem::contact_scale() =
        slidewave::contact_scale(slidewave::ContactScaling::sakai, alpha);
    SmallScene scene;
    scene.box("f f f");
    scene.law("model linear kn 1e6 damping 0.1");
    double const radius = 0.1 * alpha;
    scene.sphere(4, 5, 5, 2 * radius);
    scene.sphere(4 + 2 * radius + 0.002, 5, 5, 2 * radius);
    scene.set_velocity(1, "1 0 0");
    scene.set_velocity(2, "-1 0 0");
    scene.lines({"fix integrate all nve/sphere", "timestep 1e-5", "run 300"});
    overlap[coarse] = 2 * radius - (scene.x(2, 0) - scene.x(1, 0));
    scene.lines({"run 3000"});
    exit_speed[coarse] = scene.v(2, 0);
    slidewave::dem::contact_scale() = {};
  }
  EXPECT_GT(overlap[0], 1e-3);
  EXPECT_NEAR(overlap[1], overlap[0], 1e-12);
  EXPECT_NEAR(exit_speed[1], exit_speed[0], 1e-10);
  EXPECT_GT(exit_speed[0], 0.5);
}

// Same K: a heavier particle sinks deeper, overlap over diameter goes with D under the same speed.
TEST(Scaling, NoneKeepsTheConstants) {
  EXPECT_EQ(slidewave::contact_scale(slidewave::ContactScaling::none, 7).stiffness, 1);
  EXPECT_EQ(slidewave::contact_scale(slidewave::ContactScaling::none, 7).rotation, 1);
  SmallScene scene;
  scene.box("f f f");
  scene.law("model linear kn 1e6 tangential coulomb ks 8e5 mu 0.4");
  EXPECT_EQ(slidewave::dem::OwnPairs::current()->law().normal.kn, 1e6);
  EXPECT_EQ(slidewave::dem::OwnPairs::current()->law().slider.ks, 8e5);
}

// What the fluid does to a clump is the sum over its alpha^3 grains, for every drag law and for
// buoyancy.
TEST(Scaling, ClumpForcesAreSumsOverGrains) {
  Eigen::Matrix<double, 1, 1> const one = Eigen::Matrix<double, 1, 1>::Ones();
  Eigen::Matrix<double, 3, 1> const still = Eigen::Matrix<double, 3, 1>::Zero();
  Eigen::Matrix<double, 3, 1> const flow(2, -1, 0.5);
  double const alpha = 3;
  int const grains = 27;
  for (slidewave::DragLawEntry const& law : slidewave::drag_laws()) {
    Eigen::MatrixXd clump(1, 1);
    Eigen::MatrixXd grain(1, 1);
    law.kernel({alpha, 0.3 * one, still, flow, 1000 * one, 1e-3 * one, 0.5 * one},
               slidewave::Formulation::A, clump);
    law.kernel({1, 0.1 * one, still, flow, 1000 * one, 1e-3 * one, 0.5 * one},
               slidewave::Formulation::A, grain);
    double sum = 0;
    for (int n = 0; n < grains; ++n) {
      sum += grain(0, 0);
    }
    EXPECT_NEAR(clump(0, 0) / sum, 1, 1e-12) << law.law << " " << law.coefficient;
  }
  auto const volume = [](double radius_m) { return 4.0 / 3 * M_PI * std::pow(radius_m, 3); };
  Eigen::Vector3d const gradient(0, 10, -9810);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int n = 0; n < grains; ++n) {
    sum += slidewave::pressure_gradient_force(volume(0.1), gradient);
  }
  EXPECT_LT((slidewave::pressure_gradient_force(volume(0.3), gradient) - sum).norm(),
            1e-12 * sum.norm());
}

TEST(Scaling, NamesOfTheCase) {
  EXPECT_EQ(slidewave::contact_scaling("sakai"), slidewave::ContactScaling::sakai);
  EXPECT_EQ(slidewave::contact_scaling("proportional"), slidewave::ContactScaling::proportional);
  EXPECT_EQ(slidewave::contact_scaling("none"), slidewave::ContactScaling::none);
  EXPECT_THROW(slidewave::contact_scaling("sakia"), std::invalid_argument);
}

}  // namespace
