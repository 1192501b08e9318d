#include "particle_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace slidewave {
namespace {

constexpr int row_size = 8;  // id, radius, position, velocity

// All ranks' rows, sorted by id, on the first rank; nothing elsewhere.
std::vector<double> gathered(Table const& particles, MPI_Comm comm) {
  std::vector<double> rows(static_cast<std::size_t>(particles.size()) * row_size);
  Eigen::Map<Eigen::Matrix<double, row_size, Eigen::Dynamic>> table(rows.data(), row_size,
                                                                    particles.size());
  table.row(0) = particles["id"];
  table.row(1) = particles["radius"];
  table.middleRows(2, 3) = particles["position"];
  table.middleRows(5, 3) = particles["velocity"];

  int rank = 0, size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  int const mine = static_cast<int>(rows.size());
  std::vector<int> counts(static_cast<std::size_t>(size)), starts(counts.size(), 0);
  MPI_Gather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, comm);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::vector<double> all(
      static_cast<std::size_t>(rank == 0 ? std::accumulate(counts.begin(), counts.end(), 0) : 0));
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

template <class Value>
void put_integers(std::ofstream& out, std::size_t count, Value const& value) {
  for (std::size_t i = 0; i < count; ++i) {
    put(out, static_cast<std::int32_t>(value(i)));
  }
  out << '\n';
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
    low = std::min(low, rows[row + 4]);
    high = std::max(high, rows[row + 4]);
  }
  double const height_m = std::max(high - low, 1e-300);
  for (std::size_t row = 0; row < rows.size(); row += row_size) {
    double const part = (rows[row + 4] - low) / height_m;
    layer_of_id_[std::lround(rows[row])] =
        static_cast<int>(std::min(std::floor(part * layers_), layers_ - 1.0));
  }
}

void ParticleReport::Pictures::write_if_due(Table const& particles, long window, double time_s) {
  if (time_s < next_s_ - 1e-6 * interval_s_) {
    return;
  }
  next_s_ = interval_s_ * (std::floor(time_s / interval_s_ + 1e-6) + 1);
  std::vector<double> const rows = gathered(particles, comm_);
  int rank = 0;
  MPI_Comm_rank(comm_, &rank);
  if (rank != 0) {
    return;
  }
  if (layers_ > 0 && series_.empty()) {
    assign_layers(rows);
  }
  std::string const name = "particles_" + std::to_string(window) + ".vtk";
  write_file(folder_ / name, rows, time_s);
  series_.push_back({name, time_s});
  write_series();
}

void ParticleReport::Pictures::write_file(std::filesystem::path const& file,
                                          std::vector<double> const& rows, double time_s) const {
  std::ofstream out(file, std::ios::binary);
  std::size_t const n = rows.size() / row_size;
  out << "# vtk DataFile Version 3.0\nslidewave particles at " << time_s
      << " s\nBINARY\nDATASET POLYDATA\nPOINTS " << n << " float\n";
  put_floats(out, rows, 2, 3);
  out << "VERTICES " << n << ' ' << 2 * n << '\n';
  put_integers(out, 2 * n, [](std::size_t i) { return i % 2 == 0 ? std::size_t{1} : i / 2; });
  out << "POINT_DATA " << n << "\nSCALARS id int 1\nLOOKUP_TABLE default\n";
  put_integers(out, n, [&](std::size_t i) { return rows[i * row_size]; });
  out << "SCALARS radius float 1\nLOOKUP_TABLE default\n";
  put_floats(out, rows, 1, 1);
  if (layers_ > 0) {
    out << "SCALARS layer int 1\nLOOKUP_TABLE default\n";
    put_integers(out, n, [&](std::size_t i) {
      auto const found = layer_of_id_.find(std::lround(rows[i * row_size]));
      return found == layer_of_id_.end() ? 0 : found->second;
    });
  }
  out << "VECTORS velocity float\n";
  put_floats(out, rows, 5, 3);
  if (!out) {
    throw std::runtime_error("cannot write " + file.string());
  }
}

void ParticleReport::Pictures::write_series() const {
  std::ofstream out(folder_ / "particles.vtk.series");
  out << "{\"file-series-version\": \"1.0\", \"files\": [";
  for (std::size_t i = 0; i < series_.size(); ++i) {
    out << (i ? ",\n" : "\n") << "  {\"name\": \"" << series_[i].file
        << "\", \"time\": " << series_[i].time_s << '}';
  }
  out << "\n]}\n";
}

}  // namespace slidewave
