// Where the time of one side goes. Waiting is kept apart from transfer: a wait is the other side's
// work, and no scope counts it.
#pragma once

#include <array>
#include <chrono>

namespace slidewave {

double now_s();

enum class Phase { solve, exchange, wait, locate, void_fraction, force };

struct Profile {
  static constexpr int phases = 6;
  static constexpr char const* names[phases] = {"solve",  "exchange",      "wait",
                                                "locate", "void_fraction", "force"};
  std::array<double, phases> seconds{};

  double& of(Phase phase) { return seconds[static_cast<int>(phase)]; }
  double total() const;
};

/// Counts the time of a block, less whatever was waited or counted in scopes inside it.
class Scope {
 public:
  Scope(Profile& profile, Phase phase)
      : profile_(profile), phase_(phase), start_(now_s()), counted_(profile.total()) {}
  ~Scope() { profile_.of(phase_) += now_s() - start_ - (profile_.total() - counted_); }
  Scope(Scope const&) = delete;

 private:
  Profile& profile_;
  Phase phase_;
  double start_;
  double counted_;
};

}  // namespace slidewave
