// Time stepping of LIGGGHTS cut into windows. All windows together are one LIGGGHTS run: set up
// once, then continued, so that dumps, thermo lines, neighbour lists and fixes see no seam.
#pragma once

#include "slidewave/state.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::dem {

class StepLoop {
 public:
  explicit StepLoop(LAMMPS_NS::LAMMPS& lmp) : lmp_(lmp) {}

  /// Steps of equal length, none above `wanted_dt_s`, that fill `window_s` exactly.
  static long steps_in(double window_s, double wanted_dt_s);

  /// Sets the run up as advance() would, so that forces and contacts of the start are known.
  void prepare(double window_s, double wanted_dt_s, double remaining_s);
  /// Advances by `window_s` [s]; `remaining_s`, this window included, lets LIGGGHTS know the end.
  void advance(double window_s, double wanted_dt_s, double remaining_s);
  /// LIGGGHTS' closing summary of timings, once, if anything was run.
  void finish();
  double dt_s() const { return dt_s_; }
  bool running() const { return running_; }
  /// Step counters and time. A run that goes on is first set up as the one that saved once was,
  /// with the script's particles.
  void pass(State& state);

 private:
  void set_up(double dt_s, long total_steps);
  void change_dt(double dt_s);

  LAMMPS_NS::LAMMPS& lmp_;
  double dt_s_ = 0;
  bool running_ = false;
};

}  // namespace slidewave::dem
