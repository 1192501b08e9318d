#include "snapshot.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <stdexcept>

#include "atom.h"
#include "atom_column.h"
#include "fix_property_atom.h"
#include "lammps.h"
#include "slidewave/engine.hpp"
#include "stock_facts.h"

namespace slidewave::dem {
namespace {

constexpr int row_size = 9;  // id, layer, radius, position, velocity

// All ranks' rows, sorted by id, on the first rank; nothing elsewhere.
std::vector<double> gathered(MPI_Comm comm, std::vector<double> const& rows) {
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  int const mine = static_cast<int>(rows.size());
  std::vector<int> counts(static_cast<std::size_t>(size));
  MPI_Gather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, comm);
  std::vector<int> starts(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::vector<double> all;
  if (rank == 0) {
    all.resize(static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), 0)));
  }
  MPI_Gatherv(rows.data(), mine, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE,
              0, comm);
  std::vector<std::size_t> order(all.size() / row_size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return all[a * row_size] < all[b * row_size]; });
  std::vector<double> sorted;
  sorted.reserve(all.size());
  for (std::size_t const from : order) {
    auto const row = all.begin() + static_cast<std::ptrdiff_t>(from * row_size);
    sorted.insert(sorted.end(), row, row + row_size);
  }
  return sorted;
}

// Legacy VTK is big-endian.
template <class T>
void put(std::ofstream& out, T value) {
  char bytes[sizeof(T)];
  std::copy_n(reinterpret_cast<char const*>(&value), sizeof(T), bytes);
  std::reverse(bytes, bytes + sizeof(T));
  out.write(bytes, sizeof(T));
}

void put_floats(std::ofstream& out, std::vector<double> const& rows, int first, int count) {
  for (std::size_t row = 0; row < rows.size(); row += row_size) {
    for (int k = 0; k < count; ++k) {
      put(out, static_cast<float>(rows[row + static_cast<std::size_t>(first + k)]));
    }
  }
  out << '\n';
}

void put_integers(std::ofstream& out, std::vector<double> const& rows, std::size_t column) {
  for (std::size_t row = 0; row < rows.size(); row += row_size) {
    put(out, static_cast<std::int32_t>(rows[row + column]));
  }
  out << '\n';
}

void write_vtk(std::filesystem::path const& file, std::vector<double> const& rows, bool layers,
               double time_s) {
  std::ofstream out(file, std::ios::binary);
  std::size_t const n = rows.size() / row_size;
  out << "# vtk DataFile Version 3.0\nslidewave particles at " << time_s
      << " s\nBINARY\nDATASET POLYDATA\nPOINTS " << n << " float\n";
  put_floats(out, rows, 3, 3);
  out << "VERTICES " << n << ' ' << 2 * n << '\n';
  for (std::size_t i = 0; i < n; ++i) {
    put(out, std::int32_t{1});
    put(out, static_cast<std::int32_t>(i));
  }
  out << "\nPOINT_DATA " << n << "\nSCALARS id int 1\nLOOKUP_TABLE default\n";
  put_integers(out, rows, 0);
  out << "SCALARS radius float 1\nLOOKUP_TABLE default\n";
  put_floats(out, rows, 2, 1);
  if (layers) {
    out << "SCALARS layer int 1\nLOOKUP_TABLE default\n";
    put_integers(out, rows, 1);
  }
  out << "VECTORS velocity float\n";
  put_floats(out, rows, 6, 3);
  if (!out) {
    throw std::runtime_error("cannot write " + file.string());
  }
}

}  // namespace

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
  for (Entry const& entry : series_) {
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
  rows.reserve(static_cast<std::size_t>(atom.nlocal) * row_size);
  for (int i = 0; i < atom.nlocal; ++i) {
    Vec3 const x = wrapped(lmp_, atom.x[i]);
    double const* const v = atom.v[i];
    rows.insert(rows.end(),
                {static_cast<double>(atom.tag[i]), layer_ ? layer_->vector_atom[i] : 0.0,
                 atom.radius[i], x[0], x[1], x[2], v[0], v[1], v[2]});
  }
  rows = gathered(lmp_.world, rows);
  int rank = 0;
  MPI_Comm_rank(lmp_.world, &rank);
  if (rank != 0) {
    return;
  }
  std::string const name = "particles_" + std::to_string(window) + ".vtk";
  write_vtk(folder_ / name, rows, layer_ != nullptr, time_s);
  series_.push_back({name, time_s});
  std::ofstream out(folder_ / "particles.vtk.series");
  out << "{\"file-series-version\": \"1.0\", \"files\": [";
  for (std::size_t i = 0; i < series_.size(); ++i) {
    out << (i ? ",\n" : "\n") << "  {\"name\": \"" << series_[i].file
        << "\", \"time\": " << series_[i].time_s << '}';
  }
  out << "\n]}\n";
}

}  // namespace slidewave::dem
