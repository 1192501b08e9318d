// A particle engine on one page: spheres that never touch, dealt out to the ranks, driven by drag,
// pressure gradient and weight. It shows all that an engine owes the coupler.
#include "fault.hpp"
#include "slidewave/physics/exponential_kick.hpp"
using namespace slidewave;

struct FakeDem : ParticleEngine {
  Session& session;
  double number(char const* key) const { return session.scene().number(key); }
  Vec3 gravity = session.scene().vector("physics.gravity"), received = Vec3::Zero();
  double length = number("parameters.length"), radius = number("parameters.radius");
  double mass = number("parameters.particle_density") * 4 / 3 * M_PI * std::pow(radius, 3);
  Eigen::Matrix3Xd x, v, impulse, travel;  // one column a particle
  Table now;                               // the last answers
  long const total = long(number("parameters.particles"));
  long const begin = total * session.rank() / session.size();
  long const end = total * (session.rank() + 1) / session.size();

  explicit FakeDem(Session& s) : session(s) {
    x.resize(3, end - begin);
    for (long i = begin; i < end; ++i) {  // scattered: particles of every rank meet every cell
      Eigen::Array3d const share = i * Eigen::Array3d(0.8191725134, 0.6710436067, 0.5497004779);
      Eigen::Array3d const size(length, 1, 0.5), low(0, 0, 0.5);
      x.col(i - begin) = low + size * (share - share.floor());
    }
    v = impulse = travel = 0 * x;
    bool const stiff = s.scene().text("coupling.regime", "mild") == "stiff";
    for (Field const& field : {Field{"drag", "kg/s", 1},
                               {"fluid_velocity", "m/s", 3},
                               {"force", "N", 3},
                               {"memory", "-", stiff ? 8 : 4}})
      now.add(field);
    now.resize(x.cols());
  }
  Box bounds() const override { return {Vec3::Zero(), Vec3(length, 1, 1)}; }
  void gather(Table& particles) override {
    particles.resize(x.cols());
    particles["position"] = x;
    particles["radius"].setConstant(radius);
    particles["mass"].setConstant(mass);
    if (particles.has("velocity")) particles["velocity"] = v;
    if (particles.has("impulse")) particles["impulse"] = impulse;
    if (particles.has("memory")) particles["memory"] = now["memory"];
    if (!particles.has("travel")) return;  // wanted in the stiff regime only
    particles["travel"] = travel;
    particles["other_force"].colwise() = mass * gravity;
    particles["stiffest"].setZero();  // they never touch
  }
  std::vector<std::string> extras() const override { return {"travel", "other_force", "stiffest"}; }
  void apply(Table const& answers) override {
    impulse.setZero();
    travel.setZero();
    received.setZero();
    for (Field const& field : answers.fields()) now[field.name] = answers[field.name];
  }
  void advance(Window const& window) override {
    break_down(session, "dem", window.index);
    double const dt = window.length_s() / 10;
    for (int step = 0; step < (dt > 0 ? 10 : 0); ++step) {
      kick(dt / 2, dropped(session, "drop_substep", window.index, step == 7));
      x += dt * v;
      travel += dt * v;
      x.row(0) =
          x.row(0).unaryExpr([this](double p) { return p - length * std::floor(p / length); });
      kick(dt / 2, false);
    }
    spoil(session, window.index, x, v);
    if (dropped(session, "lose_particle", window.index, session.rank() == 0)) resize(x.cols() - 1);
  }
  /// Half a step: all forces together through the exponential; the drag's share is kept.
  void kick(double h, bool forget) {
    for (long i = 0; i < x.cols(); ++i) {
      Vec3 const u = now["fluid_velocity"].col(i), force = now["force"].col(i) + mass * gravity;
      auto const kicked = exponential_kick<Vec3>(v.col(i), u, now["drag"](0, i), force, mass, h);
      v.col(i) = kicked.velocity;
      received += kicked.drag_impulse;
      if (!forget) impulse.col(i) += kicked.drag_impulse;
    }
  }
  void resize(long left) {
    for (Eigen::Matrix3Xd* column : {&x, &v, &impulse, &travel})
      column->conservativeResize(3, left);
    now.resize(left);
  }
  bool passes_state() const override { return !fault(session, "no_state"); }
  void pass(State& state) override {
    for (auto& [name, column] :
         {std::pair("x", &x), {"v", &v}, {"impulse", &impulse}, {"travel", &travel}})
      state.pass_part(name, column->data(), 3 * begin, column->size());
    auto memory = now["memory"];
    state.pass_part("memory", memory.data(), memory.rows() * begin, memory.size());
  }
  std::optional<Vec3> received_impulse() const override { return received; }
};

int main(int, char** arguments) {
  Session session(Role::dem, arguments[1]);
  return guarded(session, [](Session& s) {
    FakeDem engine(s);
    s.state("gravity", "0 0 -9.81");
    s.state("boundary", "pbb");
    if (fault(s, "partly_held")) s.state("partly_held", "z");
    return run(s, engine);
  });
}
