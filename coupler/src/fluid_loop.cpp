// The fluid side's loop: collect -> place -> deposit -> exchange -> advance -> sample -> answer. In
// the concurrent scheme it answers with what the last window left, before it advances.
#include <utility>

#include "closures.hpp"
#include "crash.hpp"
#include "inbox.hpp"
#include "relay.hpp"
#include "reporter.hpp"
#include "signals.hpp"
#include "window_drag.hpp"

namespace slidewave {
namespace {

/// Below this share of water a particle is in air, which cannot take a ledger without jets.
constexpr double air_saturation = 0.01;

/// The column that the ledger [kg m/s] came in holds the force that repays it [N] from repay() on.
constexpr char const* repaid_column = "ledger";

class FluidLoop {
 public:
  FluidLoop(Session::Impl& session, FluidEngine& engine, Agreed const& agreed)
      : session_(session),
        engine_(engine),
        agreed_(agreed),
        models_(agreed.models),
        windows_(Windows::of(session.scene)),
        checkpoints_(session, engine, windows_),
        relay_(session),
        inbox_(session, agreed) {
    for (Field const& field : agreed.layout.to_fluid) {
      if (field.name != "cell_hint") {  // used where the message came in
        particles_.add(field);
      }
    }
    for (Field const& field : agreed.layout.to_dem) {
      if (field.name != "cell") {  // kept apart, as whole numbers
        particles_.add(field);
      }
    }
    plan_samples();
    if (models_.ledger() && !models_.drag) {  // stay 0
      particles_.add({"drag", "kg/s", 1});
      if (!models_.lift) {
        particles_.add({"velocity", "m/s", 3});
      }
    }
    if (models_.porosity()) {
      particles_.add({"volume", "m3", 1});
    }
    if (models_.lift) {
      particles_.add({"lift", "N", 3});
      if (!models_.drag) {
        particles_.add({"fluid_velocity", "m/s", 3});
      }
    }
    if (models_.stiff || models_.concurrent) {
      particles_.add({"response", "kg/s", 1});
    }
    if (models_.stiff || models_.archimedes()) {
      gravity_m_s2_ = session.scene.vector("physics.gravity");
    }
    bool const goes_on = checkpoints_.find();
    if (session.is_root()) {
      session.say(describe(agreed));
      reporter_ = std::make_unique<Reporter>(session, agreed, windows_, checkpoints_);
    }
    if (goes_on) {
      checkpoints_.load([this](State& state) { pass(state); });
    }
  }

  void run() {
    Wishes now;
    for (long n = checkpoints_.window() + 1; n <= windows_.count() && !now.stop; ++n) {
      Window window = windows_[n];
      now = checkpoints_.settle(collect(n, checkpoints_.wishes(n)), n);
      window.stop = now.stop;
      window.checkpoint = now.checkpoint;
      report_last();
      bool const at_once = models_.concurrent && n > 0;  // window 0 makes the first state
      begin(window);
      if (at_once) {
        answer(window, at_once_);
      }
      advance(window);
      if (!at_once) {
        answer(window, at_end_);
      }
      unreported_ = n;
      if (now.checkpoint) {
        save(window);
      }
    }
    report_last();
    if (reporter_) {
      reporter_->finish(now.stop);
    }
  }

 private:
  /// A field of the engine's and the column that it goes to.
  struct Wanted {
    std::string field, column;
  };

  /// What any rank wishes for the end of this window.
  Wishes collect(long n, Wishes mine) {
    if (session_.world.has_partner()) {
      return inbox_.collect(engine_, particles_, cell_, n, mine);
    }
    double wishes[2] = {mine.stop ? 1.0 : 0.0, mine.checkpoint ? 1.0 : 0.0};
    session_.agreement.sum_side(wishes, 2, "all fluid ranks to end the window");
    return {wishes[0] > 0, wishes[1] > 0};
  }

  /// All that lives across windows on this side.
  void pass(State& state) {
    engine_.pass(state);
    if (reporter_) {
      reporter_->pass(state);
    }
  }

  void save(Window const& window) {
    report_last();
    checkpoints_.save(
        window, [this](State& state) { pass(state); }, reporter_ ? reporter_->history_bytes() : 0,
        reporter_ ? reporter_->spent() : Spent());
  }

  void begin(Window const& window) {
    sums_ = FluidSums();
    {
      Scope const scope(session_.profile, Phase::void_fraction);
      engine_.place(std::as_const(particles_)["position"], cell_);
      if (models_.porosity()) {
        auto const radius = particles_["radius"];
        auto volume = particles_["volume"];
        for (long i = 0; i < particles_.size(); ++i) {
          volume(0, i) = volume_of(radius(0, i));
        }
        engine_.deposit(std::as_const(particles_)["volume"]);
      }
    }
    Scope const scope(session_.profile, Phase::force);
    list_samples(at_start_);
    if (!models_.ledger()) {
      engine_.sample_all(samples_);
      evaluate(window, RowRange::all(particles_));
      return;
    }
    Table const& read = particles_;
    if (models_.moves_fluid_along()) {
      engine_.add_mass(read["added_mass"]);
    }
    ledger_in_air_ = Vec3::Zero();
    engine_.sample_and_exchange(
        samples_,
        [&](long begin, long count) {
          evaluate(window, {begin, count});
        },
        read[reaction()], read["velocity"], read[repaid_column]);
  }

  /// What acts on the fluid in the coming window, from what was sampled at its start.
  void evaluate(Window const& window, RowRange rows) {
    if (models_.drag) {
      evaluate_drag(models_, rows, particles_);
    }
    if (models_.moves_fluid_along()) {
      evaluate_added_mass(models_, rows, particles_);
    }
    if (models_.lift) {
      evaluate_lift(models_, rows, particles_);
    }
    if (!models_.ledger()) {
      return;
    }
    repay(window, rows);
    if (models_.lift) {
      some(repaid_column, rows) -= some("lift", rows);
    }
    if (models_.stiff) {
      foresee(window.length_s(), gravity_m_s2_, rows, particles_);
    }
    if (models_.concurrent) {
      take_at_once(rows);
    }
  }

  Table::Column some(char const* column, RowRange rows) {
    Table::Column all = particles_[column];
    return {all.data() + all.rows() * rows.begin, all.rows(), rows.count};
  }

  /// The force that pays the ledger back to the fluid; a particle in air keeps its own.
  void repay(Window const& window, RowRange rows) {
    double const rate = window.length_s() > 0 ? 1 / window.length_s() : 0;
    auto ledger = particles_["ledger"];
    if (agreed_.saturation) {
      auto const saturation = particles_["saturation"];
      for (long i = rows.begin; i < rows.end(); ++i) {
        if (saturation(0, i) < air_saturation) {
          ledger_in_air_ += ledger.col(i);
          ledger.col(i).setZero();
        }
      }
    }
    some("ledger", rows) *= rate;
  }

  /// Concurrent: the fluid takes the drag of the window's start as a force that does not change, so
  /// that what it gives is known when the particles are answered.
  void take_at_once(RowRange rows) {
    auto const slip = some("fluid_velocity", rows) - some("velocity", rows);
    some(repaid_column, rows) -= slip * some("drag", rows).row(0).asDiagonal();
    some("response", rows).setZero();
  }

  void advance(Window const& window) {
    Scope const scope(session_.profile, Phase::solve);
    engine_.advance(window);
    columns_ = engine_.quantities();
    add_given(window.length_s());
  }

  /// Serial: particles receive what the fluid has become; concurrent: what the last window left.
  void answer(Window const& window, std::vector<Wanted> const& wanted) {
    {
      Scope const scope(session_.profile, Phase::force);
      list_samples(wanted);
      engine_.sample_all(samples_);
      if (models_.ledger()) {
        book(window.length_s());
      }
      if (models_.pressure_gradient) {
        add_pressure();
      }
      if (models_.force()) {
        evaluate_force(models_, gravity_m_s2_, particles_);
      }
      if (models_.torque) {
        evaluate_torque(models_, particles_);
      }
      if (models_.lift || models_.moves_fluid_along()) {
        push(models_, particles_);
      }
      if (models_.stiff) {
        answer_in_kick_form(window.length_s(), agreed_.in_plane, particles_);
      }
    }
    if (session_.world.has_partner()) {
      inbox_.answer(particles_, cell_, window.index);
    }
  }

  /// The column of what acts on the fluid per slip.
  char const* reaction() const { return models_.stiff || models_.concurrent ? "response" : "drag"; }

  /// What each particle's share of the source took from the fluid, less what was paid back. `given`
  /// holds the fluid's mean velocity before.
  void book(double length_s) {
    Table const& read = particles_;
    auto const drag = read[reaction()], velocity = read["velocity"], repaid = read[repaid_column];
    auto given = particles_["given"];
    if (models_.concurrent) {
      given = -length_s * repaid;
      return;
    }
    for (long i = 0; i < particles_.size(); ++i) {
      Vec3 const slip = given.col(i) - velocity.col(i);
      given.col(i) = length_s * (drag(0, i) * slip - repaid.col(i));
    }
    if (models_.moves_fluid_along()) {
      auto const acceleration = read["acceleration"], mass = read["added_mass"];
      for (long i = 0; i < particles_.size(); ++i) {
        given.col(i) += length_s * mass(0, i) * acceleration.col(i);
      }
    }
  }

  void add_given(double window_s) {
    if (models_.ledger()) {
      Eigen::Map<Vec3>(sums_.given) = engine_.given_impulse();
      if (models_.stiff) {
        Eigen::Map<Vec3>(sums_.given) += window_s * engine_.solid_reaction_force();
      }
      Eigen::Map<Vec3>(sums_.ledger_in_air) = ledger_in_air_;
    }
    if (models_.porosity()) {
      sums_.solid_volume_m3 = engine_.solid_volume_m3();
    }
  }

  /// `force` holds the pressure gradient still.
  void add_pressure() {
    if (!models_.porosity()) {
      return;
    }
    Eigen::Map<Vec3>(sums_.cell_pressure) = engine_.solid_pressure_force();
    Table const& read = particles_;
    auto const gradient = read["force"], volume = read["volume"];
    Eigen::Map<Vec3> whole(sums_.particle_pressure);
    for (long i = 0; i < particles_.size(); ++i) {
      Vec3 const share = volume(0, i) * gradient.col(i);
      whole += share;
      sums_.particle_pressure_abs += share.norm();
    }
  }

  /// The row of a finished window: the particle side's part comes after its advance.
  void report_last() {
    if (unreported_ < 0) {
      return;
    }
    Window const window = windows_[std::exchange(unreported_, -1)];
    take_times(session_.profile, sums_);
    session_.agreement.sum_side(numbers_of(sums_), count_of<FluidSums>(),
                                "all fluid ranks to add up");
    if (!reporter_) {
      return;
    }
    if (session_.world.has_partner()) {
      relay_.receive(window.index, dem_sums_, dem_columns_);
    }
    reporter_->add(window, dem_sums_, dem_columns_, sums_, columns_);
  }

  /// Some go where a force or an impulse is made of them.
  void plan_samples() {
    for (Need const& need : models_.needs()) {
      std::string const& name = need.field.name;
      if (name == "velocity") {
        at_start_.push_back({name, "fluid_velocity"});
        if (models_.drag) {
          at_end_.push_back({name, "fluid_velocity"});
        }
      } else if (name == "mean_velocity") {
        at_end_.push_back({name, "given"});
      } else if (name == "pressure_gradient") {
        at_end_.push_back({name, "force"});
        at_once_.push_back({name, "force"});
      } else {
        particles_.add(need.field);
        bool const later = name == "drag_reaction" || name == "acceleration" ||
                           name == "viscous_stress" || (name == "vorticity" && models_.torque);
        bool const first = !later || (name == "vorticity" && models_.lift);
        if (first) {
          at_start_.push_back({name, name});
        }
        if (later) {
          at_end_.push_back({name, name});
        }
      }
    }
    if (models_.ledger() && agreed_.saturation) {
      at_start_.push_back({"saturation", "saturation"});
      particles_.add({"saturation", "-", 1});
    }
  }

  void list_samples(std::vector<Wanted> const& wanted) {
    samples_.clear();
    for (Wanted const& one : wanted) {
      samples_.push_back({one.field, particles_[one.column]});
    }
  }

  Session::Impl& session_;
  FluidEngine& engine_;
  Agreed const& agreed_;
  Models const& models_;
  Windows windows_;
  Checkpoints checkpoints_;
  Relay relay_;
  Inbox inbox_;
  Table particles_;
  /// Sampled at the start and at the end of a window; and for answers that do not wait for its end.
  std::vector<Wanted> at_start_, at_end_, at_once_;
  std::vector<Sample> samples_;
  std::vector<int> cell_;
  Vec3 ledger_in_air_ = Vec3::Zero();
  Vec3 gravity_m_s2_ = Vec3::Zero();
  FluidSums sums_;
  DemSums dem_sums_;
  std::vector<Quantity> columns_;
  std::vector<Quantity> dem_columns_;
  long unreported_ = -1;  ///< finished, but its row is not written; -1: none
  std::unique_ptr<Reporter> reporter_;
};

}  // namespace

int run(Session& session, FluidEngine& engine) {
  try {
    Agreed const agreed =
        handshake(session.impl(), {engine.samples(), engine.features(), engine.bounds()});
    watch_signals();  // again: an engine may have taken them
    report_crashes_again();
    FluidLoop(session.impl(), engine, agreed).run();
    session.leave();
    return 0;
  } catch (InputError const& error) {
    session.fail(error.what(), 2);
  } catch (std::exception const& error) {
    session.fail(error.what(), 1);
  }
}

}  // namespace slidewave
