// The particle side's loop: gather -> send -> receive -> apply -> advance.
#include <cmath>
#include <utility>

#include "crash.hpp"
#include "dem_watch.hpp"
#include "outbox.hpp"
#include "relay.hpp"
#include "reporter.hpp"
#include "signals.hpp"

namespace slidewave {
namespace {

class DemLoop {
 public:
  DemLoop(Session::Impl& session, ParticleEngine& engine, Agreed const& agreed)
      : session_(session),
        engine_(engine),
        agreed_(agreed),
        windows_(Windows::of(session.scene)),
        checkpoints_(session, engine, windows_),
        relay_(session),
        watch_(agreed.models),
        outbox_(session, agreed) {
    for (Field const& field : Layout::gathered(agreed.models, session.world.has_partner())) {
      particles_.add(field);
    }
    for (Field const& field : Layout::answered(agreed.models)) {
      answers_.add(field);
    }
    engine_.expect(particles_, answers_);
    bool const goes_on = checkpoints_.find();
    if (!session.world.has_partner() && session.is_root()) {
      session.say(describe(agreed));
      reporter_ = std::make_unique<Reporter>(session, agreed, windows_, checkpoints_);
    }
    if (goes_on) {
      checkpoints_.load([this](State& state) { pass(state); });
      if (checkpoints_.fluid_ranks() != session.world.partner_size) {
        outbox_.forget_homes();
      }
    }
  }

  void run() {
    Wishes now;
    for (long n = checkpoints_.window() + 1; n <= windows_.count() && !now.stop; ++n) {
      gather();
      report_last();
      Window window = windows_[n];
      now = checkpoints_.settle(exchange(n, checkpoints_.wishes(n)), n);
      window.stop = now.stop;
      window.checkpoint = now.checkpoint;
      advance(window);
      unreported_ = n;
      if (now.checkpoint) {
        save(window);
      }
    }
    gather();
    report_last();
    if (session_.world.has_partner() && session_.is_root()) {
      relay_.finish();
    }
    if (reporter_) {
      reporter_->finish(now.stop);
    }
  }

 private:
  void gather() {
    Scope const scope(session_.profile, Phase::exchange);
    engine_.gather(particles_);
  }

  /// What any rank wishes for the end of this window.
  Wishes exchange(long n, Wishes mine) {
    if (!session_.world.has_partner()) {
      double wishes[2] = {mine.stop ? 1.0 : 0.0, mine.checkpoint ? 1.0 : 0.0};
      session_.agreement.sum_side(wishes, 2, "all dem ranks to end the window");
      return {wishes[0] > 0, wishes[1] > 0};
    }
    Wishes const all = outbox_.send(particles_, n, mine);
    Scope const scope(session_.profile, Phase::exchange);
    answers_.resize(particles_.size());
    engine_.offer(answers_);
    outbox_.receive(particles_, answers_, n);
    watch_.look(particles_, answers_, windows_[n].length_s(), session_.agreement);
    engine_.apply(answers_);
    return all;
  }

  /// All that lives across windows on this side.
  void pass(State& state) {
    outbox_.pass(state);
    engine_.pass(state);
    if (reporter_) {
      reporter_->pass(state);
    }
  }

  void save(Window const& window) {
    gather();
    report_last();
    checkpoints_.save(
        window, [this](State& state) { pass(state); }, reporter_ ? reporter_->history_bytes() : 0,
        reporter_ ? reporter_->spent() : Spent());
  }

  void advance(Window const& window) {
    Scope const scope(session_.profile, Phase::solve);
    engine_.advance(window);
    columns_ = engine_.quantities();
  }

  /// The row of a finished window, from particles gathered after it.
  void report_last() {
    if (unreported_ < 0) {
      return;
    }
    Window const window = windows_[std::exchange(unreported_, -1)];
    DemSums sums = add_up();
    session_.agreement.sum_side(numbers_of(sums), count_of<DemSums>(), "all dem ranks to add up");
    if (!session_.is_root()) {
      return;
    }
    if (reporter_) {
      reporter_->add(window, sums, columns_, FluidSums(), {});
    } else {
      relay_.send(window.index, sums, columns_);
    }
  }

  DemSums add_up() const {
    DemSums sums;
    sums.particles = static_cast<double>(particles_.size());
    sums.mass_kg = particles_["mass"].sum();
    Census const& census = outbox_.census();
    sums.volume_m3 = census.volume_m3;
    sums.nearest_cell = static_cast<double>(census.nearest_cell);
    sums.outside = static_cast<double>(census.outside);
    if (agreed_.models.ledger()) {
      auto const impulse = particles_["impulse"];
      auto const received = engine_.received_impulse();
      Eigen::Map<Vec3>(sums.received) = received ? *received : Vec3(impulse.rowwise().sum());
      Eigen::Map<Vec3>(sums.ledger) = outbox_.ledger(particles_);
      sums.received_abs = (agreed_.in_plane.asDiagonal() * impulse).colwise().norm().sum();
    }
    if (session_.is_root()) {
      sums.drag_response = watch_.drag_response();
      sums.kernels_crossed = watch_.kernels_crossed();
    }
    take_times(session_.profile, sums);
    return sums;
  }

  Session::Impl& session_;
  ParticleEngine& engine_;
  Agreed const& agreed_;
  Windows windows_;
  Checkpoints checkpoints_;
  Relay relay_;
  DemWatch watch_;
  Outbox outbox_;
  Table particles_;
  Table answers_;
  std::vector<Quantity> columns_;
  long unreported_ = -1;  ///< finished, but its row is not written; -1: none
  std::unique_ptr<Reporter> reporter_;
};

}  // namespace

int run(Session& session, ParticleEngine& engine) {
  try {
    Agreed const agreed = handshake(session.impl(), {{}, engine.features(), engine.bounds()});
    watch_signals();  // again: an engine may have taken them
    report_crashes_again();
    check_particle_needs(agreed.models, engine);
    DemLoop(session.impl(), engine, agreed).run();
    session.leave();
    return 0;
  } catch (InputError const& error) {
    session.fail(error.what(), 2);
  } catch (std::exception const& error) {
    session.fail(error.what(), 1);
  }
}

}  // namespace slidewave
