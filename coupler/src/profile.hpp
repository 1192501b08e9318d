// Where the time of one side goes. Waiting is kept apart from transfer: a wait is the other side's
// work, and no scope counts it.
#pragma once

#include <array>
#include <chrono>

namespace slidewave {

double now_s();
/// Processor time of this process [s]: what it costs, however busy the machine is.
double processor_s();

enum class Phase { solve, exchange, wait, locate, void_fraction, force };

struct Profile {
  static constexpr int phases = 6;
  static constexpr char const* names[phases] = {"solve",  "exchange",      "wait",
                                                "locate", "void_fraction", "force"};
  std::array<double, phases> seconds{};            ///< on the wall
  std::array<double, phases> processor_seconds{};  ///< of this rank

  double& of(Phase phase) { return seconds[static_cast<int>(phase)]; }
  void add(Phase phase, double wall_s, double busy_s) {
    of(phase) += wall_s;
    processor_seconds[static_cast<int>(phase)] += busy_s;
  }
  double total() const;
  double processor_total() const;
};

/// Counts the time of a block, less whatever was waited or counted in scopes inside it.
class Scope {
 public:
  Scope(Profile& profile, Phase phase)
      : profile_(profile),
        phase_(phase),
        wall_s_(now_s() - profile.total()),
        busy_s_(processor_s() - profile.processor_total()) {}
  ~Scope() {
    profile_.add(phase_, now_s() - profile_.total() - wall_s_,
                 processor_s() - profile_.processor_total() - busy_s_);
  }
  Scope(Scope const&) = delete;

 private:
  Profile& profile_;
  Phase phase_;
  double wall_s_;  ///< at the start, less all that had been counted by then
  double busy_s_;
};

}  // namespace slidewave
