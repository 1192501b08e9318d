#include "slidewave/particle_vtk.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <numeric>
#include <stdexcept>

namespace slidewave {
namespace {

constexpr int row_size = particle_row_size;

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

// A full disk shows when the last bytes leave the buffer.
void finish(std::ofstream& out, std::filesystem::path const& file) {
  if (!out.flush()) {
    throw std::runtime_error("cannot write " + file.string() + ": " + std::strerror(errno));
  }
}

}  // namespace

std::vector<double> gather_particle_rows(std::vector<double> const& rows, MPI_Comm comm) {
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

void write_particle_vtk(std::filesystem::path const& file, std::vector<double> const& rows,
                        bool layers, double time_s) {
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
  finish(out, file);
}

void write_vtk_series(std::filesystem::path const& file,
                      std::vector<ParticlePicture> const& pictures) {
  std::ofstream out(file);
  out << "{\"file-series-version\": \"1.0\", \"files\": [";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    out << (i ? ",\n" : "\n") << "  {\"name\": \"" << pictures[i].file
        << "\", \"time\": " << pictures[i].time_s << '}';
  }
  out << "\n]}\n";
  finish(out, file);
}

}  // namespace slidewave
