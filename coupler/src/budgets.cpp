#include "budgets.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "pass.hpp"

namespace slidewave {
namespace {

using Map3 = Eigen::Map<Vec3 const>;

/// Something over nothing is a whole defect, nothing over nothing is none.
double ratio(double part, double whole) {
  return part == 0 ? 0 : (whole > 0 ? part / whole : 1);
}

void add_vector(std::vector<Quantity>& columns, std::string const& name, std::string const& unit,
                double const* values) {
  for (int k = 0; k < 3; ++k) {
    columns.push_back({fmt::format("{}_{}_{}", name, "xyz"[k], unit), values[k]});
  }
}

}  // namespace

void Budgets::add(double window_s, double gravity_m_s2, DemSums const& dem,
                  FluidSums const& fluid) {
  if (!started_) {
    started_ = true;
    first_ = dem;
  }
  last_ = dem;
  fluid_ = fluid;
  Vec3 const ledger = Map3(dem.ledger);
  Vec3 const received = Map3(dem.received);
  Vec3 const residual = Map3(fluid.given) - received - (ledger - ledger_);
  residual_ += in_plane_.cwiseProduct(residual).norm();
  received_abs_ += dem.received_abs;
  constraint_ += (Vec3::Ones() - in_plane_).cwiseProduct(received);
  ledger_ = ledger;
  turnover_[windows_++ % outstanding_windows] =
      dem.received_abs + dem.mass_kg * gravity_m_s2 * window_s;
  solid_volume_defect_ = ratio(std::abs(fluid.solid_volume_m3 - dem.volume_m3), dem.volume_m3);
  Vec3 const pressure =
      in_plane_.cwiseProduct(Map3(fluid.particle_pressure) - Map3(fluid.cell_pressure));
  pressure_defect_ = ratio(pressure.norm(), fluid.particle_pressure_abs);
}

void Budgets::pass(State& state) {
  state.pass("budgets.started", started_);
  pass_sums(state, "budgets.first", first_);
  pass_sums(state, "budgets.last", last_);
  pass_sums(state, "budgets.fluid", fluid_);
  state.pass("budgets.ledger_kg_m_s", ledger_);
  state.pass("budgets.residual_kg_m_s", residual_);
  state.pass("budgets.received_kg_m_s", received_abs_);
  state.pass("budgets.turnover_kg_m_s", turnover_.data(), outstanding_windows);
  state.pass("budgets.windows", windows_);
  state.pass("budgets.solid_volume_defect", solid_volume_defect_);
  state.pass("budgets.pressure_defect", pressure_defect_);
  state.pass("budgets.constraint_kg_m_s", constraint_);
}

double Budgets::momentum_defect() const {
  return ratio(residual_, received_abs_);
}

double Budgets::momentum_outstanding() const {
  return ratio(ledger_.norm(), std::accumulate(turnover_.begin(), turnover_.end(), 0.0));
}

std::vector<Quantity> Budgets::columns() const {
  std::vector<Quantity> columns = {{"particles", last_.particles},
                                   {"particles_lost", particles_lost()},
                                   {"mass_lost_kg", first_.mass_kg - last_.mass_kg}};
  if (models_.porosity() || models_.drag || models_.pressure_gradient) {
    columns.push_back({"nearest_cell", last_.nearest_cell});
    columns.push_back({"outside", last_.outside});
  }
  if (models_.drag) {
    columns.push_back({"max_drag_response", last_.drag_response});
  }
  if (models_.drag && models_.porosity()) {
    columns.push_back({"max_kernels_crossed", last_.kernels_crossed});
  }
  if (models_.porosity()) {
    columns.push_back({"solid_volume_defect", solid_volume_defect_});
  }
  if (models_.porosity() && models_.pressure_gradient) {
    columns.push_back({"pressure_defect", pressure_defect_});
  }
  if (models_.ledger()) {
    columns.push_back({"momentum_defect", momentum_defect()});
    columns.push_back({"momentum_outstanding", momentum_outstanding()});
    add_vector(columns, "given", "kg_m_s", fluid_.given);
    add_vector(columns, "received", "kg_m_s", last_.received);
    add_vector(columns, "ledger", "kg_m_s", last_.ledger);
    columns.push_back({"ledger_in_air_kg_m_s", Map3(fluid_.ledger_in_air).norm()});
    if (in_plane_ != Vec3::Ones()) {
      columns.push_back({"constraint_impulse_kg_m_s", constraint_.norm()});
    }
  }
  return columns;
}

}  // namespace slidewave
