// Particle snapshots for ParaView, written by the first rank: LIGGGHTS' own VTK dumps hang a run of
// two programs. particles_<window>.vtk is a legacy binary POLYDATA file with the point data id,
// radius [m], velocity [m/s] and, if asked for, layer; particles.vtk.series lists them with times.
#pragma once

#include <filesystem>
#include <vector>

#include "slidewave/particle_vtk.hpp"
#include "slidewave/state.hpp"

namespace LAMMPS_NS {
class FixPropertyAtom;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace slidewave::dem {

class Snapshots {
 public:
  /// `layers` > 0: particles carry the layer of initial elevation, 0 (lowest) to layers - 1, that
  /// they start in. Written to `folder`. Collective, as is write().
  Snapshots(LAMMPS_NS::LAMMPS& lmp, std::filesystem::path folder, int layers);
  void write(long window, double time_s);
  /// The list of what was written.
  void pass(State& state);

 private:
  void assign_layers(int layers);

  LAMMPS_NS::LAMMPS& lmp_;
  std::filesystem::path folder_;
  LAMMPS_NS::FixPropertyAtom* layer_ = nullptr;
  std::vector<ParticlePicture> series_;
};

}  // namespace slidewave::dem
