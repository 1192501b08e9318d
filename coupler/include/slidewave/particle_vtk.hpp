// Particles as files that ParaView opens: legacy VTK, binary POLYDATA, with the point data id,
// radius [m], velocity [m/s] and, if asked for, layer; and the .series file that gives them times.
#pragma once

#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

namespace slidewave {

/// Doubles a particle in the rows below: id, layer, radius, position (3), velocity (3).
constexpr int particle_row_size = 9;

/// All ranks' rows, sorted by id, on the first rank of `comm`; nothing elsewhere. Collective.
std::vector<double> gather_particle_rows(std::vector<double> const& rows, MPI_Comm comm);

/// Writes rows; layers only where `layers`. Throws std::runtime_error where it cannot.
void write_particle_vtk(std::filesystem::path const& file, std::vector<double> const& rows,
                        bool layers, double time_s);

struct ParticlePicture {
  std::string file;
  double time_s = 0;
};
void write_vtk_series(std::filesystem::path const& file,
                      std::vector<ParticlePicture> const& pictures);

}  // namespace slidewave
