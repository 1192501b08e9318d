#include "step_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "finish.h"
#include "fix.h"
#include "force.h"
#include "integrate.h"
#include "lammps.h"
#include "modify.h"
#include "pair.h"
#include "timer.h"
#include "update.h"

namespace slidewave::dem {

long StepLoop::steps_in(double window_s, double wanted_dt_s) {
  return std::max(1L, static_cast<long>(std::ceil(window_s / wanted_dt_s - 1e-9)));
}

void StepLoop::set_up(double dt_s, long total_steps) {
  LAMMPS_NS::Update& update = *lmp_.update;
  long const most = std::numeric_limits<int>::max();
  update.dt = dt_s;
  update.timestep_set = true;
  update.whichflag = 1;
  update.nsteps = static_cast<int>(std::min(total_steps, most));
  update.firststep = update.beginstep = update.ntimestep;
  update.laststep = update.endstep = update.ntimestep + update.nsteps;
  lmp_.init();
  update.integrate->setup();
  lmp_.timer->init();
  lmp_.timer->barrier_start(TIME_LOOP);
  dt_s_ = dt_s;
  running_ = true;
}

void StepLoop::change_dt(double dt_s) {
  lmp_.update->update_time();
  lmp_.update->dt = dt_s;
  for (int i = 0; i < lmp_.modify->nfix; ++i) {
    lmp_.modify->fix[i]->reset_dt();
  }
  if (lmp_.force->pair) {
    lmp_.force->pair->reset_dt();
  }
  lmp_.update->integrate->reset_dt();
  dt_s_ = dt_s;
}

void StepLoop::prepare(double window_s, double wanted_dt_s, double remaining_s) {
  if (!running_) {
    long const steps = steps_in(window_s, wanted_dt_s);
    set_up(window_s / static_cast<double>(steps),
           steps * std::lround(std::max(1.0, remaining_s / window_s)));
  }
}

void StepLoop::advance(double window_s, double wanted_dt_s, double remaining_s) {
  long const steps = steps_in(window_s, wanted_dt_s);
  double const dt_s = window_s / static_cast<double>(steps);
  prepare(window_s, wanted_dt_s, remaining_s);
  if (std::abs(dt_s - dt_s_) > 1e-9 * dt_s_) {  // windows t1 - t0 differ by round-off
    change_dt(dt_s);
  }
  lmp_.update->integrate->run(static_cast<int>(steps));
}

void StepLoop::pass(State& state) {
  LAMMPS_NS::Update& update = *lmp_.update;
  double dt_s = dt_s_;
  state.pass("steps.dt_s", dt_s);
  if (!state.saving()) {
    update.dt = dt_s;
    update.timestep_set = true;
    update.whichflag = 1;
    lmp_.init();
    update.integrate->setup_minimal(1);
    lmp_.timer->init();
    lmp_.timer->barrier_start(TIME_LOOP);
    dt_s_ = dt_s;
    running_ = true;
  }
  for (auto const& [name, value] : {std::pair("now", &update.ntimestep),
                                    {"first", &update.firststep},
                                    {"last", &update.laststep},
                                    {"begin", &update.beginstep},
                                    {"end", &update.endstep},
                                    {"time_is_of", &update.atimestep}}) {
    long number = *value;
    state.pass(std::string("steps.") + name, number);
    *value = number;
  }
  state.pass("steps.count", update.nsteps);
  state.pass("steps.time_s", update.atime);
}

void StepLoop::finish() {
  if (!running_) {
    return;
  }
  running_ = false;
  lmp_.timer->barrier_stop(TIME_LOOP);
  lmp_.update->nsteps = static_cast<int>(lmp_.update->ntimestep - lmp_.update->firststep);
  lmp_.update->integrate->cleanup();
  LAMMPS_NS::Finish(&lmp_).end(1);
}

}  // namespace slidewave::dem
