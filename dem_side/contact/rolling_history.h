// What both rolling models of walls share: history, signs, where the moment goes.
#pragma once

#include "contact_books.h"
#include "contact_models.h"
#include "rolling_laws.h"
#include "update.h"

namespace slidewave::dem {

class RollingHistory {
 public:
  void keep(LIGGGHTS::IContactHistorySetup& setup, bool twist) {
    rolling_ = setup.add_history_value("roll_x", "1");
    setup.add_history_value("roll_y", "1");
    setup.add_history_value("roll_z", "1");
    // The angle of twist and the normal both change sign with the order of the bodies.
    twist_ = twist ? setup.add_history_value("twist", "0") : -1;
  }
  bool kept() const { return rolling_ >= 0; }

  void forget(LIGGGHTS::ContactModels::SurfacesCloseData& contact) const {
    for (int k = 0; k < 3 && kept(); ++k) {
      contact.contact_history[rolling_ + k] = 0;
    }
    if (twist_ >= 0) {
      contact.contact_history[twist_] = 0;
    }
  }

  /// Adds the moments; `twisting` is used only if twist is kept.
  void act(LIGGGHTS::ContactModels::SurfacesIntersectData const& contact, double dt_s,
           RotationSpring const& rolling, RotationSpring const& twisting,
           LIGGGHTS::ContactModels::ForceData& on_i) const {
    bool const advance = contact.computeflag && contact.shearupdate;
    double* const kept = contact.contact_history + rolling_;
    double const before_J = stored(contact, rolling, twisting);
    Vec4 const n = load3(contact.en);
    Vec4 const omega = load3(contact.omega_i);
    Vec4 theta = load3(kept);
    Vec4 moment;
    double lost_J = rolling_moment(rolling, theta, n, omega, dt_s, advance, moment);
    store3(theta, kept);
    if (twist_ >= 0) {
      moment += n * twisting_moment(twisting, contact.contact_history[twist_], dot(omega, n), dt_s,
                                    advance, lost_J);
    }
    for (int k = 0; k < 3; ++k) {
      on_i.delta_torque[k] += moment[k];
    }
    if (contact.computeflag) {
      double const after_J = stored(contact, rolling, twisting);
      wall_books().now.rolling += after_J;
      wall_books().stored.rolling += advance ? after_J - before_J + lost_J : 0.0;
    }
  }

 private:
  double stored(LIGGGHTS::ContactModels::SurfacesIntersectData const& contact,
                RotationSpring const& rolling, RotationSpring const& twisting) const {
    double const* const theta = contact.contact_history + rolling_;
    double const angle = twist_ >= 0 ? contact.contact_history[twist_] : 0.0;
    return 0.5 * rolling.k * (theta[0] * theta[0] + theta[1] * theta[1] + theta[2] * theta[2]) +
           0.5 * twisting.k * angle * angle;
  }

  int rolling_ = -1;
  int twist_ = -1;
};

}  // namespace slidewave::dem
