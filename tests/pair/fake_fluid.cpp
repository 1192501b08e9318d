// A fluid engine on one page: a row of cells along x, each with one velocity. It shows all that an
// engine owes the coupler; a real one has a better mesh, kernel and solver (docs/add_an_engine.md).
#include "fault.hpp"
using namespace slidewave;

struct FakeFluid : FluidEngine {
  explicit FakeFluid(Session& s) : session(s) {}
  Session& session;
  double number(char const* key) const { return session.scene().number(key); }
  int cells = int(number("parameters.cells"));  // of the whole row; this rank has first..last-1
  int first = cells * session.rank() / session.size();
  int last = cells * (session.rank() + 1) / session.size();
  double dx = number("parameters.length") / cells, volume = dx;  // 1 m wide, 1 m high
  double density = number("parameters.fluid_density"), viscosity = number("parameters.viscosity");
  Vec3 gravity = session.scene().vector("physics.gravity"), given = Vec3::Zero();
  Eigen::ArrayXd solid = Eigen::ArrayXd::Zero(cells), drag = solid, mass = drag + density * volume;
  Eigen::Matrix3Xd u = Vec3(number("parameters.fluid_velocity"), 0, 0).replicate(1, cells);
  Eigen::Matrix3Xd mean_u = u, source = 0 * u;  // source: sum of K v + force [N]
  Eigen::Matrix3Xd reaction = 0 * u;            // drag's force density over the void fraction
  Eigen::Matrix3Xd grad_p = density * gravity * Eigen::RowVectorXd::LinSpaced(cells, 1, 2);
  std::vector<int> cell;  // of each particle, as placed

  Box bounds() const override { return {Vec3(first * dx, 0, 0), Vec3(last * dx, 1, 1)}; }
  std::vector<Field> samples() const override {
    Field const velocity{"velocity", "m/s", 3}, mean{"mean_velocity", "m/s", 3};
    Field const rho{name_of_density(session), "kg/m3", 1}, mu{"viscosity", "Pa s", 1};
    return {velocity,
            mean,
            rho,
            mu,
            {"void_fraction", "-", 1},
            {"pressure_gradient", "Pa/m", 3},
            {"drag_reaction", "Pa/m", 3}};
  }
  Home locate(Vec3 const& x, int) override {
    Vec3 const inside = x.cwiseMax(bounds().low).cwiseMin(bounds().high);
    return {std::clamp(int(inside[0] / dx), first, last - 1), (x - inside).norm()};
  }
  void place(Table::ConstColumn, std::vector<int> const& owner) override { cell = owner; }
  void deposit(Table::ConstColumn particle_volume) override {
    solid.setZero();
    for (long i = 0; i < particle_volume.cols(); ++i) solid[cell[i]] += particle_volume(0, i);
    if (fault(session, "drop_volume")) solid[cells / 2] = 0;
  }
  void exchange(Table::ConstColumn K, Table::ConstColumn v, Table::ConstColumn force) override {
    drag.setZero();
    source.setZero();
    for (long i = 0; i < K.cols(); ++i) {
      drag[cell[i]] += K(0, i);
      source.col(cell[i]) += K(0, i) * v.col(i) + force.col(i);
    }
    mass = density * (volume - solid);
  }
  /// Implicit in the drag, four steps; what leaves the fluid is added up with the solved velocity.
  void advance(Window const& window) override {
    break_down(session, "fluid", window.index);
    given = Vec3::Zero();
    mean_u = reaction = 0 * u;
    double const dt = window.length_s() / 4;
    for (int k = 0; k < (dt > 0 ? 4 * (last - first) : 0); ++k) {
      int const c = first + k % (last - first);
      u.col(c) = (mass[c] * u.col(c) + dt * source.col(c)) / (mass[c] + dt * drag[c]);
      mean_u.col(c) += u.col(c) / 4;
      reaction.col(c) += (drag[c] * u.col(c) - source.col(c)) / (volume - solid[c]) / 4;
      if (forgotten(session, window.index, c == cells / 2)) continue;
      given += dt * (drag[c] * u.col(c) - source.col(c));
    }
    if (dropped(session, "fluid_nan", window.index)) u.setConstant(NAN);
  }
  void sample(std::string const& field, Table::Column out) override {
    for (long i = 0; i < out.cols(); ++i) {
      if (field == "velocity") out.col(i) = u.col(cell[i]);
      if (field == "mean_velocity") out.col(i) = mean_u.col(cell[i]);
      if (field == "density") out(0, i) = density;
      if (field == "viscosity") out(0, i) = viscosity;
      if (field == "void_fraction") out(0, i) = 1 - solid[cell[i]] / volume;
      if (field == "pressure_gradient") out.col(i) = grad_p.col(cell[i]);
      if (field == "drag_reaction") out.col(i) = reaction.col(cell[i]);
    }
  }
  Vec3 given_impulse() const override { return given; }
  double solid_volume_m3() const override { return solid.sum(); }
  Vec3 solid_pressure_force() const override { return grad_p * solid.matrix(); }
  Vec3 solid_reaction_force() const override { return reaction * solid.matrix(); }
  bool passes_state() const override { return true; }
  void pass(State& state) override {  // what the next window does not set anew
    state.pass_part("u", u.col(first).data(), 3 * first, 3 * (last - first));
  }
  std::vector<Quantity> quantities() const override { return {{"cells", double(cells)}}; }
};

int main(int, char** arguments) {
  Session session(Role::fluid, arguments[1]);
  return guarded(session, [](Session& s) {
    FakeFluid engine{s};
    s.state("gravity", fault(s, "gravity") ? "0 0 -1" : "0 0 -9.81");
    s.state("boundary", "pbb");  // x periodic, y and z bounded
    return run(s, engine);
  });
}
