// The one worker of ESyS-Particle: its command loop runs in a coroutine, so that the coupler gets
// control between windows, and its particles get the fluid's kick when they are integrated.
#pragma once

#include <memory>

#include "slidewave/coupler.hpp"

namespace slidewave::esys {

class Worker {
 public:
  /// Starts the command loop; returns when the master lets the worker leave.
  explicit Worker(Session& session);
  ~Worker();

  /// Obeys the master's commands until it lets the worker leave again.
  void obey();

  Box bounds() const;
  /// Sum of all gravity groups [m/s2].
  Vec3 gravity() const;
  /// Fills the columns that the table has.
  void gather(Table& particles) const;
  /// Same rows as the last gather.
  void apply(Table const& answers);
  Vec3 received_impulse() const;
  double max_overlap() const;

  struct State;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace slidewave::esys
