// LAMMPS as a particle engine: runs the case's set-up script on the session's communicator, then
// advances window by window, each a LAMMPS run that goes on where the last one ended. Screen output
// goes to DIR/log.dem, the working directory is DIR/dem.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "slidewave/coupler.hpp"
#include "slidewave/particle_report.hpp"

namespace LAMMPS_NS {
class FixSlidewave;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace slidewave::lammps {

class LammpsEngine : public ParticleEngine {
 public:
  /// Reads DIR/dem/parameters and the script dem.script, and states gravity, boundary and end_time.
  explicit LammpsEngine(Session& session);
  ~LammpsEngine() override;

  Box bounds() const override;
  std::vector<Quantity> quantities() const override { return quantities_; }
  std::vector<std::string> extras() const override { return {"type"}; }
  std::vector<Feature> features() const override;
  void gather(Table& particles) override;
  void apply(Table const& answers) override;
  void advance(Window const& window) override;
  std::optional<Vec3> received_impulse() const override;

 private:
  void set_up_scene();
  void state_facts();
  void add_kick(Table const& answers);
  void run_steps(double window_s);
  void check_particles();
  void look();

  Session& session_;
  std::filesystem::path folder_;  // DIR/dem
  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp_;
  std::unique_ptr<ParticleReport> report_;
  LAMMPS_NS::FixSlidewave* kick_ = nullptr;  // none in a dry scene
  Table seen_;                               // what the report is made from
  std::vector<Quantity> quantities_;
  double wanted_dt_s_ = 0;
  double dt_s_ = 0;
  bool running_ = false;  // a run was set up: the next one goes on
};

}  // namespace slidewave::lammps
