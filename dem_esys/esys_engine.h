// ESyS-Particle as a particle engine: rank 0 is its master, which runs the case's Python script,
// rank 1 its one worker, which holds all particles. Screen output goes to DIR/log.dem.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "master.h"
#include "slidewave/coupler.hpp"
#include "slidewave/particle_report.hpp"
#include "worker.h"

namespace slidewave::esys {

class EsysEngine : public ParticleEngine {
 public:
  /// Reads DIR/dem/parameters and the script dem.script, and states gravity and end_time.
  explicit EsysEngine(Session& session);

  Box bounds() const override { return worker_ ? worker_->bounds() : Box{}; }
  std::vector<Quantity> quantities() const override { return quantities_; }
  std::vector<Feature> features() const override;
  void gather(Table& particles) override;
  void apply(Table const& answers) override;
  void advance(Window const& window) override;
  std::optional<Vec3> received_impulse() const override;

 private:
  void look();
  void check_numbers() const;

  Session& session_;
  std::unique_ptr<Master> master_;  // on rank 0
  std::unique_ptr<Worker> worker_;  // on rank 1
  std::unique_ptr<ParticleReport> report_;
  Table seen_;
  std::vector<Quantity> quantities_;
  long steps_ = 0;  // taken so far
  double wanted_dt_s_ = 0;
};

}  // namespace slidewave::esys
