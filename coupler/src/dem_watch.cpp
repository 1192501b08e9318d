#include "dem_watch.hpp"

#include <cmath>

#include "slidewave/physics/limits/courant.hpp"

namespace slidewave {

void DemWatch::look(Table const& particles, Table const& answers, double window_s,
                    Agreement const& agreement) {
  if (!models_.drag) {
    return;
  }
  double most[2] = {0, 0};
  if (particles.size() > 0) {
    most[0] = window_s * (answers["drag"].array() / particles["mass"].array()).maxCoeff();
    if (models_.porosity()) {
      double const speed_m_s = std::sqrt(particles["velocity"].colwise().squaredNorm().maxCoeff());
      most[1] = limits::courant(speed_m_s, window_s, models_.smoothing_length_m);
    }
  }
  agreement.max_side(most, 2, "all dem ranks to compare their drag");
  drag_response_ = most[0];
  kernels_crossed_ = most[1];
}

}  // namespace slidewave
