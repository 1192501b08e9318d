#include "reporter.hpp"

#include <algorithm>

namespace slidewave {

Reporter::Reporter(Session::Impl& session, Agreed const& agreed, Windows const& windows)
    : session_(session),
      budgets_(agreed.models, agreed.in_plane),
      history_(session.scene.directory() / "history.csv"),
      progress_(windows.end_s(), session.scene.text("output.headline", "")),
      summary_(session, agreed),
      gravity_m_s2_(session.scene.vector("physics.gravity").norm()) {}

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
  summary_.add(window, columns, dem, fluid);

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
