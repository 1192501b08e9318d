#include "snapshot.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "atom_column.h"
#include "fix_property_atom.h"
#include "lammps.h"
#include "slidewave/engine.hpp"
#include "stock_facts.h"

namespace slidewave::dem {

Snapshots::Snapshots(LAMMPS_NS::LAMMPS& lmp, std::filesystem::path folder, int layers)
    : lmp_(lmp), folder_(std::move(folder)) {
  if (layers > 0) {
    assign_layers(layers);
  }
}

void Snapshots::assign_layers(int layers) {
  layer_ = add_atom_column(lmp_, "layer", {0.0});
  LAMMPS_NS::Atom const& atom = *lmp_.atom;
  double range_m[2] = {1e300, 1e300};  // lowest, and minus the highest
  for (int i = 0; i < atom.nlocal; ++i) {
    range_m[0] = std::min(range_m[0], atom.x[i][2]);
    range_m[1] = std::min(range_m[1], -atom.x[i][2]);
  }
  MPI_Allreduce(MPI_IN_PLACE, range_m, 2, MPI_DOUBLE, MPI_MIN, lmp_.world);
  double const height_m = std::max(-range_m[1] - range_m[0], 1e-300);
  for (int i = 0; i < atom.nlocal; ++i) {
    double const part = (atom.x[i][2] - range_m[0]) / height_m;
    layer_->vector_atom[i] = std::min(std::floor(part * layers), layers - 1.0);
  }
}

void Snapshots::pass(State& state) {
  std::vector<std::string> files;
  std::vector<double> times_s;
  for (ParticlePicture const& entry : series_) {
    files.push_back(entry.file);
    times_s.push_back(entry.time_s);
  }
  state.pass("snapshots.files", files);
  state.pass("snapshots.times_s", times_s);
  series_.clear();
  for (std::size_t k = 0; k < files.size(); ++k) {
    series_.push_back({files[k], times_s[k]});
  }
}

void Snapshots::write(long window, double time_s) {
  LAMMPS_NS::Atom const& atom = *lmp_.atom;
  std::vector<double> rows;
  rows.reserve(static_cast<std::size_t>(atom.nlocal) * particle_row_size);
  for (int i = 0; i < atom.nlocal; ++i) {
    Vec3 const x = wrapped(lmp_, atom.x[i]);
    double const* const v = atom.v[i];
    rows.insert(rows.end(),
                {static_cast<double>(atom.tag[i]), layer_ ? layer_->vector_atom[i] : 0.0,
                 atom.radius[i], x[0], x[1], x[2], v[0], v[1], v[2]});
  }
  rows = gather_particle_rows(rows, lmp_.world);
  int rank = 0;
  MPI_Comm_rank(lmp_.world, &rank);
  if (rank != 0) {
    return;
  }
  std::string const name = "particles_" + std::to_string(window) + ".vtk";
  write_particle_vtk(folder_ / name, rows, layer_ != nullptr, time_s);
  series_.push_back({name, time_s});
  write_vtk_series(folder_ / "particles.vtk.series", series_);
}

}  // namespace slidewave::dem
