#include "reporter.hpp"

#include <algorithm>

namespace slidewave {

Reporter::Reporter(Session::Impl& session, Agreed const& agreed, Windows const& windows,
                   Checkpoints const& checkpoints)
    : session_(session),
      budgets_(agreed.models, agreed.in_plane),
      history_(session.scene.directory() / "history.csv", checkpoints.window() >= 0),
      progress_(windows.end_s(), session.scene.text("output.headline", "")),
      summary_(session, agreed),
      gravity_m_s2_(session.scene.vector("physics.gravity").norm()),
      before_(checkpoints.spent()) {
  if (checkpoints.window() >= 0) {
    ++before_.restarts;
    summary_.goes_on(before_.wall_s, before_.restarts);
    progress_.begins_at(windows[checkpoints.window()].t1_s);
  }
}

void Reporter::pass(State& state) {
  budgets_.pass(state);
  history_.pass(state);
  summary_.pass(state);
}

Spent Reporter::spent() const {
  Spent spent = before_;
  spent.wall_s = now_s() - session_.start_s + before_.wall_s;
  std::copy_n(fluid_.seconds, Profile::phases, spent.fluid_s);
  std::copy_n(dem_.seconds, Profile::phases, spent.dem_s);
  return spent;
}

void Reporter::add(Window const& window, DemSums const& dem,
                   std::vector<Quantity> const& dem_columns, FluidSums const& fluid,
                   std::vector<Quantity> const& fluid_columns) {
  budgets_.add(window.length_s(), gravity_m_s2_, dem, fluid);
  std::vector<Quantity> columns;
  for (auto const* part : {&fluid_columns, &dem_columns}) {
    std::copy_if(part->begin(), part->end(), std::back_inserter(columns),
                 [](Quantity const& quantity) { return quantity.name != "cells"; });
  }
  auto const own = budgets_.columns();
  columns.insert(columns.end(), own.begin(), own.end());
  history_.add(window, columns);
  for (Quantity const& quantity : fluid_columns) {
    if (quantity.name == "cells") {
      summary_.cells(quantity.value);
    }
  }
  dem_ = dem;
  fluid_ = fluid;
  for (int k = 0; k < Profile::phases; ++k) {
    dem_.seconds[k] += before_.dem_s[k];
    fluid_.seconds[k] += before_.fluid_s[k];
  }
  summary_.add(window, columns, dem_, fluid_);

  int const wait = static_cast<int>(Phase::wait);
  auto const& world = session_.world;
  bool const is_fluid = session_.role == Role::fluid;
  double const fluid_wait_s = fluid.seconds[wait] / (is_fluid ? world.size : 1);
  double const dem_wait_s =
      dem.seconds[wait] / (is_fluid ? std::max(1, world.partner_size) : world.size);
  if (setup_wait_s_[0] < 0) {
    setup_wait_s_[0] = fluid_wait_s;
    setup_wait_s_[1] = dem_wait_s;
  }
  std::string const line = progress_.line(window, columns, dem_wait_s - setup_wait_s_[1],
                                          fluid_wait_s - setup_wait_s_[0]);
  if (!line.empty()) {
    session_.say(line);
  }
}

void Reporter::finish(bool stopped) {
  summary_.write(stopped ? "stopped" : "completed");
}

}  // namespace slidewave
