#include "particle_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidewave {
namespace {

constexpr int row_size = particle_row_size;

// This rank's rows, layer 0.
std::vector<double> rows_of(Table const& particles) {
  std::vector<double> rows(static_cast<std::size_t>(particles.size()) * row_size);
  Eigen::Map<Eigen::Matrix<double, row_size, Eigen::Dynamic>> table(rows.data(), row_size,
                                                                    particles.size());
  table.row(0) = particles["id"];
  table.row(2) = particles["radius"];
  table.middleRows(3, 3) = particles["position"];
  table.middleRows(6, 3) = particles["velocity"];
  return rows;
}

}  // namespace

ParticleReport::Pictures::Pictures(Session const& session)
    : comm_(session.comm()),
      folder_(std::filesystem::absolute(session.scene().directory()) / "dem"),
      interval_s_(session.scene().number("output.interval")),
      layers_(static_cast<int>(session.scene().number("output.layers", 0.0))) {}

void ParticleReport::Pictures::assign_layers(std::vector<double> const& rows) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (std::size_t row = 0; row < rows.size(); row += row_size) {
    low = std::min(low, rows[row + 5]);
    high = std::max(high, rows[row + 5]);
  }
  double const height_m = std::max(high - low, 1e-300);
  for (std::size_t row = 0; row < rows.size(); row += row_size) {
    double const part = (rows[row + 5] - low) / height_m;
    layer_of_id_[std::lround(rows[row])] =
        static_cast<int>(std::min(std::floor(part * layers_), layers_ - 1.0));
  }
}

void ParticleReport::Pictures::write_if_due(Table const& particles, long window, double time_s) {
  if (time_s < next_s_ - 1e-6 * interval_s_) {
    return;
  }
  next_s_ = interval_s_ * (std::floor(time_s / interval_s_ + 1e-6) + 1);
  std::vector<double> rows = gather_particle_rows(rows_of(particles), comm_);
  int rank = 0;
  MPI_Comm_rank(comm_, &rank);
  if (rank != 0) {
    return;
  }
  if (layers_ > 0 && series_.empty()) {
    assign_layers(rows);
  }
  for (std::size_t row = 0; layers_ > 0 && row < rows.size(); row += row_size) {
    auto const found = layer_of_id_.find(std::lround(rows[row]));
    rows[row + 1] = found == layer_of_id_.end() ? 0 : found->second;
  }
  std::string const name = "particles_" + std::to_string(window) + ".vtk";
  write_particle_vtk(folder_ / name, rows, layers_ > 0, time_s);
  series_.push_back({name, time_s});
  write_vtk_series(folder_ / "particles.vtk.series", series_);
}

void ParticleReport::Pictures::pass(State& state) {
  std::vector<std::string> files;
  std::vector<double> times_s, layers;
  for (ParticlePicture const& entry : series_) {
    files.push_back(entry.file);
    times_s.push_back(entry.time_s);
  }
  for (auto const& [id, layer] : layer_of_id_) {
    layers.insert(layers.end(), {static_cast<double>(id), static_cast<double>(layer)});
  }
  state.pass("pictures.next_s", next_s_);
  state.pass("pictures.files", files);
  state.pass("pictures.times_s", times_s);
  state.pass("pictures.layers", layers);
  series_.clear();
  for (std::size_t k = 0; k < files.size(); ++k) {
    series_.push_back({files[k], times_s[k]});
  }
  for (std::size_t k = 0; k < layers.size(); k += 2) {
    layer_of_id_[std::lround(layers[k])] = static_cast<int>(layers[k + 1]);
  }
}

}  // namespace slidewave
