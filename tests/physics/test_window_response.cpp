// The window response against the exponential of the oscillator's matrix, and its limits.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "slidewave/physics/contact_secant.hpp"
#include "slidewave/physics/window_response.hpp"

using namespace slidewave;

namespace {

using Matrix = Eigen::Matrix<long double, 3, 3>;

/// State (y, v, f) of m y'' = f - K y' - k y after W, by scaling and squaring.
Matrix flow(double m, double drag, double k, double w) {
  Matrix a;
  a << 0, 1, 0, -k / m, -drag / m, 1 / m, 0, 0, 0;
  a *= w;
  int halvings = 0;
  for (long double norm = a.norm(); norm > 1e-3L; norm /= 2) {
    ++halvings;
  }
  a /= std::pow(2.0L, halvings);
  Matrix term = Matrix::Identity(), sum = term;
  for (int n = 1; n < 12; ++n) {
    term = term * a / n;
    sum += term;
  }
  for (int n = 0; n < halvings; ++n) {
    sum = (sum * sum).eval();
  }
  return sum;
}

}  // namespace

TEST(WindowResponse, IsTheOscillatorsForAllStiffness) {
  double const mass = 0.7, window = 0.03;
  for (double const x : {0.0, 1e-6, 1e-3, 0.1, 0.49, 0.51, 1.0, 3.0, 10.0, 100.0, 1e4}) {
    for (double const s :
         {0.0, 1e-6, 1e-3, 0.2, 0.49, 0.51, x * x / 4, x * x / 4 * 1.001, 1.0, 30.0, 1e3, 1e5}) {
      double const drag = x * mass / window, k = s * mass / window / window;
      WindowResponse const found = window_response(mass, drag, k, window);
      Matrix const truth = flow(mass, drag, k, window);
      double const unit_v = window / (1 + x + std::sqrt(s));
      double const unit_f = window * window / mass / (1 + x + s);
      EXPECT_NEAR(found.velocity_s, static_cast<double>(truth(0, 1)), 2e-9 * unit_v)
          << x << " " << s;
      EXPECT_NEAR(found.force_m_N, static_cast<double>(truth(0, 2)), 2e-9 * unit_f)
          << x << " " << s;
    }
  }
}

TEST(WindowResponse, HeldGrainsGoOnAsTheyDo) {
  WindowResponse const held = window_response(2, 5, held_stiffness, 0.1);
  EXPECT_EQ(held.velocity_s, 0.1);
  EXPECT_EQ(held.force_m_N, 0);
}

TEST(ContactStiffness, ErrsHighRisesAtOnceAndFallsByFour) {
  double const most = stiffest_contact(0.5, 1e-3);
  EXPECT_EQ(most, 2e6);
  EXPECT_EQ(contact_stiffness(0, 0, 0, 0, 0), 0) << "touches nothing";
  EXPECT_EQ(contact_stiffness(9, 3, 0, 1, 0), 0) << "has let go";
  EXPECT_EQ(contact_stiffness(0, 0, 5, 0, most), most) << "touched before anything moved";
  EXPECT_NEAR(contact_stiffness(0, 3, 5, 1e-3, most), 1.4 * 3e3, 1e-9);
  EXPECT_EQ(contact_stiffness(8e4, 3, 5, 1e-3, most), 2e4);
  EXPECT_EQ(contact_stiffness(8e4, 1e-4, 5, 1e-3, most), 8e4) << "a steady bed tells nothing";
  EXPECT_EQ(contact_stiffness(8e4, 1e6, 5, 1e-3, most), most);
  EXPECT_EQ(contact_stiffness(8e4, 1, 5, 1, held_stiffness), held_stiffness);
}
