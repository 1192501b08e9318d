// Choosing a model by name, and the batch loop against one grain at a time.
#include <gtest/gtest.h>

#include <cmath>

#include "slidewave/physics/drag_models.hpp"

namespace slidewave {
namespace {

using Eigen::MatrixXd;

struct Particles {
  MatrixXd radius, velocity, fluid, density, viscosity, eps, drag;
  explicit Particles(int n) {
    std::srand(7);
    radius = (MatrixXd::Random(1, n).array() * 0.4 + 1).matrix() * 1e-3;
    velocity = MatrixXd::Random(3, n);
    fluid = 3 * MatrixXd::Random(3, n);
    density = (MatrixXd::Random(1, n).array() * 500 + 501).matrix();
    viscosity = (MatrixXd::Random(1, n).array() * 1e-3 + 1.1e-3).matrix();
    eps = (MatrixXd::Random(1, n).array() * 0.3 + 0.65).matrix();
    drag = MatrixXd::Constant(1, n, -1);
  }
  DragInputs inputs(double alpha) const {
    return {alpha, radius, velocity, fluid, density, viscosity, eps};
  }
};

TEST(DragModels, ListEveryLawAndCoefficient) {
  std::vector<std::string> const laws{"di_felice", "rong",     "single_sphere", "ergun",
                                      "wen_yu",    "gidaspow", "koch_hill",     "beetstra"};
  EXPECT_EQ(drag_law_names(), laws);
  for (auto const& law : laws) {
    for (auto const& coefficient : drag_coefficient_names()) {
      EXPECT_EQ(drag_model(law, coefficient, "A").law, law);
    }
  }
}

TEST(DragModels, UnknownNamesSuggestTheNearest) {
  auto message = [](char const* law, char const* coefficient, char const* formulation) {
    try {
      drag_model(law, coefficient, formulation);
    } catch (std::invalid_argument const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("di_felix", "stokes", "A").find("did you mean \"di_felice\""),
            std::string::npos);
  EXPECT_NE(message("di_felice", "brown_lawyer", "A").find("did you mean \"brown_lawler\""),
            std::string::npos);
  EXPECT_NE(message("xyzzy", "stokes", "A").find("known: di_felice, rong"), std::string::npos);
  EXPECT_NE(message("ergun", "", "C").find("formulation"), std::string::npos);
}

TEST(DragModels, BatchEqualsOneGrainAtATime) {
  for (int const n : {0, 1, 7, 33}) {
    Particles p(n);
    drag_coefficients(drag_model("di_felice", "brown_lawler", "B"), p.inputs(2.5), p.drag);
    for (int i = 0; i < n; ++i) {
      Grain const grain{2 * p.radius(i) / 2.5, (p.fluid.col(i) - p.velocity.col(i)).norm(),
                        p.density(i), p.viscosity(i), p.eps(i)};
      double const expected = 15.625 * DiFelice<BrownLawler>::drag(grain) / p.eps(i);
      EXPECT_NEAR(p.drag(i) / expected, 1, 1e-13);
    }
  }
}

TEST(DragModels, WithoutPorosityTheVoidFractionIsOne) {
  Particles p(5);
  MatrixXd const none(1, 0);
  MatrixXd const ones = MatrixXd::Ones(1, 5);
  MatrixXd with(1, 5);
  auto const model = drag_model("rong", "dalla_valle", "A");
  model.kernel({1, p.radius, p.velocity, p.fluid, p.density, p.viscosity, none}, Formulation::A,
               p.drag);
  model.kernel({1, p.radius, p.velocity, p.fluid, p.density, p.viscosity, ones}, Formulation::A,
               with);
  EXPECT_EQ(p.drag, with);
}

TEST(DragModels, EveryModelIsFiniteSmoothAndPositiveOverItsRange) {
  // eps 0.15 to 1, Re 0 to 1e8: neighbours in Re (1 %) or eps (0.001) give neighbouring K.
  auto drag = [](DragLawEntry const& entry, double slip, double eps) {
    MatrixXd const radius = MatrixXd::Constant(1, 1, 5e-4), v = MatrixXd::Zero(3, 1),
                   density = MatrixXd::Constant(1, 1, 1000), mu = MatrixXd::Constant(1, 1, 1e-3);
    MatrixXd u = MatrixXd::Zero(3, 1), k(1, 1);
    u(1, 0) = slip;
    MatrixXd const void_fraction = MatrixXd::Constant(1, 1, eps);
    entry.kernel({1, radius, v, u, density, mu, void_fraction}, Formulation::A, k);
    return k(0, 0);
  };
  for (auto const& entry : drag_laws()) {
    bool const ergun = std::string(entry.law) == "ergun";  // its K at rest falls to 0 at eps = 1
    for (double eps = 0.15; eps < 1.0001; eps += 0.05) {
      double last = drag(entry, 0, eps);
      double const first = last;
      for (double slip = 1e-14; slip < 2e2; slip *= 1.01) {
        double const k = drag(entry, slip, eps);
        ASSERT_TRUE(std::isfinite(k) && k > 0) << entry.law << " " << slip << " " << eps;
        if (slip < 1e-9 && !ergun) {
          ASSERT_NEAR(k / first, 1, 1e-3) << entry.law << " " << slip << " " << eps;
        }
        if (!(ergun && eps > 0.99)) {
          ASSERT_NEAR(k / last, 1, 0.02) << entry.law << " " << slip << " " << eps;
        }
        last = k;
      }
    }
    for (double const slip : {0.0, 1e-6, 1e-3, 0.3, 100.0}) {
      for (double eps = 0.15; eps < 0.99; eps += 0.001) {
        ASSERT_NEAR(drag(entry, slip, eps + 0.001) / drag(entry, slip, eps), 1, 0.13)
            << entry.law << " " << slip << " " << eps;
      }
    }
  }
}

}  // namespace
}  // namespace slidewave
