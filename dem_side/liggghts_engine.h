// LIGGGHTS as a particle engine: runs the case's set-up script on the session's communicator, then
// advances window by window. Screen output goes to DIR/log.dem, the working directory is DIR/dem.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "energy_audit.h"
#include "slidewave/coupler.hpp"
#include "slidewave/particle_report.hpp"
#include "step_loop.h"
#include "step_watch.h"
#include "touching.h"

namespace LAMMPS_NS {
class FixSlidewave;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace slidewave::dem {

class LiggghtsEngine : public ParticleEngine {
 public:
  /// Reads DIR/dem/parameters and the script dem.script, and states gravity, boundary and end_time.
  explicit LiggghtsEngine(Session& session);
  ~LiggghtsEngine() override;

  Box bounds() const override;
  std::vector<Quantity> quantities() const override { return quantities_; }
  std::vector<Feature> features() const override;
  void expect(Table const& particles, Table const& answers) override;
  void gather(Table& particles) override;
  std::vector<std::string> extras() const override {
    return {"travel", "other_force", "stiffest", "type"};
  }
  std::vector<std::string> takes() const override {
    return {"added_mass", "exchanged_force", "rotational_drag", "fluid_spin"};
  }
  void offer(Table& answers) override;
  void apply(Table const& answers) override;
  void advance(Window const& window) override;
  std::optional<Vec3> received_impulse() const override;
  bool passes_state() const override;
  void pass(State& state) override;

 private:
  void set_up_scene();
  void state_facts();
  void gather_extras(Table& particles);
  void append_to_dumps() const;
  void check_numbers() const;
  void observe();

  Session& session_;
  std::filesystem::path folder_;  // DIR/dem
  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp_;
  std::unique_ptr<StepLoop> loop_;
  std::unique_ptr<ParticleReport> report_;
  std::unique_ptr<StepWatch> step_watch_;  // with our own contact law
  std::unique_ptr<EnergyAudit> audit_;     // none where it is off or cannot close
  bool drift_told_ = false;
  LAMMPS_NS::FixSlidewave* kick_ = nullptr;  // none in a dry scene
  Table seen_;                               // what the report is made from
  std::vector<Quantity> quantities_;
  Touching touching_;
  bool extras_wanted_ = false;
  double wanted_dt_s_ = 0;
  double end_s_ = 0;
};

}  // namespace slidewave::dem
