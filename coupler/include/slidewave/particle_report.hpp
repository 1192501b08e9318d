// What any particle engine tells about its particles, from a table that it fills: the columns of
// history.csv that [observe.*] asks for, and pictures for ParaView. Optional for an engine.
//
//   [observe.slide]  type = "slide"      the whole mass: slide_speed_m_s (mass-weighted mean),
//       slide_front_x_m (99 % of the mass lies at smaller x), kinetic_energy_J (translation and
//       rotation), max_overlap (pairs, over the smaller diameter)
//   [observe.NAME]   type = "particle"  id = 1   NAME_x_m ... NAME_vz_m_s of one particle
//   [dem]  overlap_limit                 the run ends above it (default 0.3), warned from 0.1 on
//   [output]  interval, layers           DIR/dem/particles_<window>.vtk, particles.vtk.series
#pragma once

#include <memory>
#include <vector>

#include "slidewave/coupler.hpp"

namespace slidewave {

class ParticleReport {
 public:
  /// Reads the case. All calls are collective over session.comm().
  explicit ParticleReport(Session const& session);
  ~ParticleReport();

  /// Adds the columns that the calls below read: id, position [m], velocity [m/s],
  /// angular_velocity [rad/s], radius [m], mass [kg].
  static void add_columns(Table& particles);
  /// False where the case asks for nothing: the table need not be filled.
  bool wants_particles() const;
  /// Whether the next observe() uses its largest overlap: always where it is a column, else ten
  /// particle steps after the last time. `steps`: taken so far, the same on all ranks.
  bool wants_overlap(long steps);

  /// Columns of history.csv now. `max_overlap`: of this rank's pairs, over the smaller diameter.
  /// Throws InputError, the first time, for a particle that does not exist; ends the run above
  /// the limit of overlaps.
  std::vector<Quantity> observe(Table const& particles, double max_overlap);
  /// Writes a picture where output.interval says that one is due at `time_s`.
  void picture(Table const& particles, long window, double time_s);
  /// For an engine with checkpoints.
  void pass(State& state);

 private:
  struct Particle {
    std::string name;
    double id = 0;
  };
  void observe_slide(Table const& particles, double max_overlap, std::vector<Quantity>& out) const;
  void watch(double overlap);

  Session const& session_;
  bool slide_ = false;
  bool checked_ = false;
  double overlap_limit_;
  bool overlap_told_ = false;
  bool overlap_wanted_ = false;
  long next_look_ = 0;  // particle steps
  std::vector<Particle> followed_;
  class Pictures;
  std::unique_ptr<Pictures> pictures_;  // none without output.interval
};

/// x below which `part` of the mass lies [m], to a millionth of the extent. Collective over `comm`.
double mass_front_x(Table const& particles, double part, MPI_Comm comm);

}  // namespace slidewave
