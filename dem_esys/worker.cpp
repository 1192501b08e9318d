#include "worker.h"

#include <dlfcn.h>
#include <ucontext.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>
#include <unordered_map>
#include <vector>

#include "esys_headers.h"
#include "slidewave/physics/exponential_kick.hpp"
#include "world.h"

namespace slidewave::esys {
namespace {

using Lattice = TSubLattice<CRotParticle>;

/// What the fluid does to a particle during a window, and what the coupler keeps with it.
struct Answer {
  double drag_kg_s = 0;
  Vec3 fluid_velocity = Vec3::Zero(), force_N = Vec3::Zero(), impulse = Vec3::Zero();
  std::array<double, 4> memory{};
};
std::unordered_map<int, Answer> answers_of;  // by particle id
Vec3 received = Vec3::Zero();

Vec3 from(::Vec3 const& v) {
  return {v.X(), v.Y(), v.Z()};
}
::Vec3 to(Vec3 const& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

/// Before ESyS adds f dt/m to the velocity: the force in, contacts and gravity, becomes the one
/// that carries out the exact solution over the step (physics/exponential_kick.hpp).
void kick(int id, bool moves, double mass, ::Vec3 const& velocity, ::Vec3& force, double dt_s) {
  auto const found = answers_of.find(id);
  if (found == answers_of.end()) {
    return;
  }
  Answer& answer = found->second;
  Vec3 const v = from(velocity);
  Vec3 share = answer.drag_kg_s * dt_s * (answer.fluid_velocity - v);  // what a held one takes
  if (moves) {
    Vec3 const others = from(force) + answer.force_N;
    KickFactors const factors = kick_factors(answer.drag_kg_s, mass, dt_s);
    force = to(effective_force<Vec3>(factors, answer.drag_kg_s, answer.fluid_velocity, v, others));
    share =
        drag_impulse<Vec3>(factors, answer.drag_kg_s, answer.fluid_velocity, v, others, mass, dt_s);
  }
  answer.impulse += share;
  received += share;
}

struct Worker::State {
  Session& session;
  CSubLatticeControler controler;
  ucontext_t coupler, commands;
  std::vector<char> stack = std::vector<char>(16 << 20);
  bool finished = false;

  explicit State(Session& s) : session(s) {}
  Lattice& lattice() const {
    auto* const rot = dynamic_cast<Lattice*>(controler.m_lattice);
    if (!rot) {
      throw std::runtime_error(
          "the script makes no particles of type RotSphere, which the coupling needs");
    }
    return *rot;
  }
  /// Calls `see(particle)` for each particle, in the neighbour table's order.
  template <class See>
  void each(See const& see) const {
    auto handle = lattice().m_ppa->getAllParticles();
    for (auto it = handle->begin(); it != handle->end(); ++it) {
      see(**it);
    }
  }
};

namespace {

Worker::State* running = nullptr;

void run_commands() {
  try {
    running->controler.initMPI();
    running->controler.run();
  } catch (std::exception const& error) {
    running->session.fail(std::string("ESyS-Particle: ") + error.what());
  }
  running->finished = true;
}

}  // namespace

Worker::Worker(Session& session) : state_(std::make_unique<State>(session)) {
  running = state_.get();
  on_leave([this] { swapcontext(&state_->commands, &state_->coupler); });
  getcontext(&state_->commands);
  state_->commands.uc_stack.ss_sp = state_->stack.data();
  state_->commands.uc_stack.ss_size = state_->stack.size();
  state_->commands.uc_link = &state_->coupler;
  makecontext(&state_->commands, run_commands, 0);
  obey();
}

Worker::~Worker() {
  state_.release();  // its destructor would talk to the master, which has left
}

void Worker::obey() {
  swapcontext(&state_->coupler, &state_->commands);
  if (state_->finished) {
    // The master may know better why: let it speak first.
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    state_->session.fail(
        "ESyS-Particle's worker left before the run was over (exit in the script?)");
  }
}

Box Worker::bounds() const {
  auto const& particles = *state_->lattice().m_ppa;
  return {from(particles.getMinPos()), from(particles.getMaxPos())};
}

Vec3 Worker::gravity() const {
  Vec3 sum = Vec3::Zero();
  for (auto const& [name, group] : state_->lattice().m_singleParticleInteractions) {
    if (auto const* const g = dynamic_cast<::esys::lsm::BodyForceGroup<CRotParticle>*>(group)) {
      sum += from(g->getForce(1.0));
    }
  }
  return sum;
}

void Worker::gather(Table& particles) const {
  long count = 0;
  state_->each([&](CRotParticle&) { ++count; });
  particles.resize(count);
  long i = 0;
  auto const put = [&](char const* name, auto const& value) {
    if (particles.has(name)) {
      particles[name].col(i) = value;
    }
  };
  auto const one = [](double value) { return Eigen::Matrix<double, 1, 1>(value); };
  state_->each([&](CRotParticle& particle) {
    put("id", one(particle.getID()));
    put("position", from(particle.getPos()));
    put("velocity", from(particle.getVel()));
    put("angular_velocity", from(particle.getAngVel()));
    put("radius", one(particle.getRad()));
    put("mass", one(particle.getMass()));
    Answer const& answer = answers_of[particle.getID()];
    put("impulse", answer.impulse);
    put("memory", Eigen::Map<Eigen::Vector4d const>(answer.memory.data()));
    ++i;
  });
}

void Worker::apply(Table const& answers) {
  received.setZero();
  long i = 0;
  state_->each([&](CRotParticle& particle) {
    Answer& answer = answers_of[particle.getID()];
    answer.impulse.setZero();
    if (answers.has("drag")) {
      answer.drag_kg_s = answers["drag"](0, i);
      answer.fluid_velocity = answers["fluid_velocity"].col(i);
    }
    if (answers.has("force")) {
      answer.force_N = answers["force"].col(i);
    }
    if (answers.has("memory")) {
      Eigen::Map<Eigen::Vector4d>(answer.memory.data()) = answers["memory"].col(i);
    }
    if (!answer.fluid_velocity.allFinite() || !answer.force_N.allFinite() ||
        !(answer.drag_kg_s >= 0)) {
      state_->session.fail("particle " + std::to_string(particle.getID()) +
                           " received a bad drag, fluid velocity or force");
    }
    ++i;
  });
}

Vec3 Worker::received_impulse() const {
  return received;
}

double Worker::max_overlap() const {
  double largest = 0;
  auto pairs = state_->lattice().m_ppa->getFullPairList();
  for (auto it = pairs->begin(); it != pairs->end(); ++it) {
    CRotParticle const &one = *it->first, &other = *it->second;
    double const gap = (from(one.getPos()) - from(other.getPos())).norm();
    double const smaller = 2 * std::min(one.getRad(), other.getRad());
    largest = std::max(largest, (one.getRad() + other.getRad() - gap) / smaller);
  }
  return largest;
}

}  // namespace slidewave::esys

/// Stands in for libModel's function of this name, which it then calls.
void CRotParticle::integrate(double dt) {
  static auto const stock = reinterpret_cast<void (*)(CRotParticle*, double)>(
      ::dlsym(RTLD_NEXT, "_ZN12CRotParticle9integrateEd"));
  slidewave::esys::kick(getID(), m_is_dynamic, m_mass, m_vel, m_force, dt);
  stock(this, dt);
}
