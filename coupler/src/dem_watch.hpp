// What the pre-flight check foresees of the coupling, watched on the particle side in every window.
#pragma once

#include "agreement.hpp"
#include "models.hpp"
#include "slidewave/table.hpp"

namespace slidewave {

class DemWatch {
 public:
  /// Nothing is watched without drag.
  explicit DemWatch(Models const& models) : models_(models) {}

  /// All ranks of the side together, with the drag of the window that begins.
  void look(Table const& particles, Table const& answers, double window_s,
            Agreement const& agreement);

  /// Largest K W/m.
  double drag_response() const { return drag_response_; }
  /// Largest share of the kernel's length that a particle crosses at its speed; 0 without pores.
  double kernels_crossed() const { return kernels_crossed_; }

 private:
  Models const& models_;
  double drag_response_ = 0;
  double kernels_crossed_ = 0;
};

}  // namespace slidewave
