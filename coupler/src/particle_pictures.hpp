// Particles for ParaView, written by the first rank: particles_<window>.vtk, a legacy binary
// POLYDATA file with the point data id, radius [m], velocity [m/s] and, with output.layers, the
// layer of initial elevation, 0 (lowest) to layers - 1; particles.vtk.series lists them with times.
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "slidewave/particle_report.hpp"
#include "slidewave/particle_vtk.hpp"

namespace slidewave {

class ParticleReport::Pictures {
 public:
  /// Written to DIR/dem every output.interval.
  explicit Pictures(Session const& session);
  /// Collective. Layers are those of the first picture.
  void write_if_due(Table const& particles, long window, double time_s);
  /// What was written, and the layers.
  void pass(State& state);

 private:
  void assign_layers(std::vector<double> const& rows);

  MPI_Comm comm_;
  std::filesystem::path folder_;
  double interval_s_;
  int layers_;
  double next_s_ = 0;
  std::map<long, int> layer_of_id_;  // on the first rank; empty without layers
  std::vector<ParticlePicture> series_;
};

}  // namespace slidewave
