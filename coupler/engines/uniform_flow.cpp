// slidewave_uniform DIR: a prescribed fluid without mesh or walls, analytic in space and time:
//
//   u = U + A sin(2 pi t/T) + G x        U: velocity, A: amplitude, T: period, G: velocity gradient
//   grad p = rho (g - Du/Dt)             Du/Dt = A 2 pi/T cos(2 pi t/T) + G u
//
// A linear flow has no net viscous force, so this is an exact solution of the Navier-Stokes
// equations where div u = 0 (trace G = 0) and a pressure exists (G G symmetric: simple shear,
// strain, rotation). Nothing acts on it: one-way only. Keys: [uniform_flow], docs/case_format.md.
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "slidewave/coupler.hpp"

namespace {

using namespace slidewave;
using Eigen::Matrix3d;

class UniformFlow : public FluidEngine {
 public:
  explicit UniformFlow(Session const& session) : scene_(session.scene()), rank_(session.rank()) {
    if (scene_.text("coupling.reaction", "two_way") != "one_way") {
      refuse("coupling.reaction", scene_.text("coupling.reaction", "two_way"),
             "must be \"one_way\": a prescribed flow takes no momentum from particles");
    }
    positive("density", density_);
    positive("viscosity", viscosity_);
    if (scene_.has(key_of("amplitude"))) {
      omega_ = 2 * M_PI / positive("period", scene_.number(key_of("period")));
    }
    double const scale = gradient_.norm();
    Matrix3d const square = gradient_ * gradient_;
    if (std::abs(gradient_.trace()) > 1e-9 * scale ||
        (square - square.transpose()).norm() > 1e-9 * scale * scale) {
      refuse(key_of("gradient_u"), "",
             "with gradient_v and gradient_w is no flow of an incompressible fluid: the trace must "
             "be 0 and the square symmetric (simple shear, strain or rotation)");
    }
  }

  /// Everywhere, on the first rank: there is nothing to solve that others could share.
  Box bounds() const override {
    Vec3 const far = Vec3::Constant(1e300);
    return rank_ == 0 ? Box{-far, far} : Box{};
  }
  Home locate(Vec3 const&, int) override { return {rank_ == 0 ? 0 : -1, 0}; }
  void place(Table::ConstColumn position_m, std::vector<int> const&) override {
    position_m_ = position_m;
  }

  std::vector<Field> samples() const override {
    return {{"velocity", "m/s", 3},           {"density", "kg/m3", 1},
            {"viscosity", "Pa s", 1},         {"void_fraction", "-", 1},
            {"pressure_gradient", "Pa/m", 3}, {"acceleration", "m/s2", 3},
            {"viscous_stress", "Pa/m", 3},    {"vorticity", "1/s", 3}};
  }

  void advance(Window const& window) override {
    time_s_ = window.t1_s;
    double const from = omega_ * window.t0_s, to = omega_ * window.t1_s;
    bool const long_enough = to > from;  // window 0 has no length: values as they stand
    mean_sine_ = long_enough ? (std::cos(from) - std::cos(to)) / (to - from) : std::sin(to);
    mean_cosine_ = long_enough ? (std::sin(to) - std::sin(from)) / (to - from) : std::cos(to);
  }

  void sample(std::string const& field, Table::Column out) override {
    if (field == "density") {
      out.setConstant(density_);
    } else if (field == "viscosity") {
      out.setConstant(viscosity_);
    } else if (field == "void_fraction") {
      out.setOnes();
    } else if (field == "velocity") {
      out = velocities(std::sin(omega_ * time_s_));
    } else if (field == "pressure_gradient") {
      out = density_ * ((-accelerations()).colwise() + gravity_);
    } else if (field == "acceleration") {
      out = accelerations();
    } else if (field == "viscous_stress") {
      out.setZero();
    } else if (field == "vorticity") {
      Matrix3d const& g = gradient_;
      out.colwise() = Vec3(g(2, 1) - g(1, 2), g(0, 2) - g(2, 0), g(1, 0) - g(0, 1));
    } else {
      throw std::invalid_argument("slidewave_uniform has no field " + field);
    }
  }

  std::vector<Quantity> quantities() const override {
    Vec3 const u = velocity_ + std::sin(omega_ * time_s_) * amplitude_;
    return {{"flow_vx_m_s", u[0]}, {"flow_vy_m_s", u[1]}, {"flow_vz_m_s", u[2]}};  // at the origin
  }
  std::vector<Feature> features() const override {
    return {{"fluid solve", false, "prescribed flow (fluid.engine = \"uniform_flow\")"}};
  }

  bool passes_state() const override { return true; }
  void pass(State& state) override {
    state.pass("uniform_flow.time_s", time_s_);
    state.pass("uniform_flow.mean_sine", mean_sine_);
    state.pass("uniform_flow.mean_cosine", mean_cosine_);
  }

  // What only a fluid that particles act on is asked for.
  void deposit(Table::ConstColumn) override {}
  void exchange(Table::ConstColumn, Table::ConstColumn, Table::ConstColumn) override {}
  Vec3 given_impulse() const override { return Vec3::Zero(); }
  double solid_volume_m3() const override { return 0; }
  Vec3 solid_pressure_force() const override { return Vec3::Zero(); }

 private:
  static std::string key_of(std::string const& name) { return "uniform_flow." + name; }
  [[noreturn]] void refuse(std::string const& key, std::string const& value,
                           std::string const& remedy) const {
    throw InputError((scene_.directory() / "case.toml").string(), key, value, remedy);
  }
  double positive(std::string const& name, double value) const {
    if (!(value > 0)) refuse(key_of(name), std::to_string(value), "must be positive");
    return value;
  }
  Vec3 vector(std::string const& name) const {
    return scene_.has(key_of(name)) ? scene_.vector(key_of(name)) : Vec3(Vec3::Zero());
  }
  Eigen::Matrix3Xd velocities(double sine) const {
    return (gradient_ * position_m_).colwise() + Vec3(velocity_ + sine * amplitude_);
  }

  /// Du/Dt, time mean over the window, at fixed places.
  Eigen::Matrix3Xd accelerations() const {
    return (gradient_ * velocities(mean_sine_)).colwise() +
           Vec3(omega_ * mean_cosine_ * amplitude_);
  }

  Scene const& scene_;
  int rank_;
  double density_ = scene_.number("uniform_flow.density");
  double viscosity_ = scene_.number("uniform_flow.viscosity");
  Vec3 gravity_ = scene_.vector("physics.gravity");
  Vec3 velocity_ = vector("velocity"), amplitude_ = vector("amplitude");
  Matrix3d gradient_ = (Matrix3d() << vector("gradient_u").transpose(),
                        vector("gradient_v").transpose(), vector("gradient_w").transpose())
                           .finished();
  double omega_ = 0, time_s_ = 0, mean_sine_ = 0, mean_cosine_ = 1;
  Eigen::Matrix3Xd position_m_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || argv[1][0] == '-') {
    std::fputs("usage: slidewave_uniform DIR   (one mpirun starts both sides)\n", stderr);
    return 2;
  }
  Session session(Role::fluid, argv[1]);
  return guarded(session, [](Session& joined) {
    UniformFlow flow(joined);
    Vec3 const g = joined.scene().vector("physics.gravity");
    char text[80];
    std::snprintf(text, sizeof(text), "%.17g %.17g %.17g", g[0], g[1], g[2]);
    joined.state("gravity", text);
    return run(joined, flow);
  });
}
