// tangential coulomb ks K mu M [damping_s zeta]: coulomb_slider.h for pairs and walls. A wall's mu
// is its own. With mu = 0 there is no force, and no history is kept.
#pragma once

#include "contact_models.h"
#include "coulomb_slider.h"
#include "model_ids.h"
#include "model_settings.h"
#include "update.h"

namespace LIGGGHTS::ContactModels {

template <>
class TangentialModel<slidewave::dem::coulomb_id> : public TangentialModelBase {
 public:
  TangentialModel(LAMMPS* lammps, IContactHistorySetup* setup, ContactModelBase* model)
      : TangentialModelBase(lammps, setup, model) {}

  void registerSettings(Settings& settings) override {
    settings.registerDoubleSetting("ks", law_.ks, slidewave::dem::not_given);
    settings.registerDoubleSetting("mu", law_.mu, slidewave::dem::not_given);
    settings.registerDoubleSetting("damping_s", law_.zeta, 0);
  }
  void postSettings(IContactHistorySetup* setup, ContactModelBase*) override {
    if (law_.mu > 0) {
      history_ = setup->add_history_value("slip_x", "1");
      setup->add_history_value("slip_y", "1");
      setup->add_history_value("slip_z", "1");
    }
  }
  void connectToProperties(PropertyRegistry&) override {
    slidewave::dem::need_positive(*error, "coulomb", "ks", law_.ks, "in N/m");
    slidewave::dem::need_not_negative(*error, "coulomb", "mu", law_.mu, "");
    slidewave::dem::need(*error, law_.zeta >= 0 && law_.zeta < 1, "coulomb", "damping_s", law_.zeta,
                         "a fraction of critical damping, 0 to 1");
  }

  void surfacesIntersect(SurfacesIntersectData const& contact, ForceData& on_i,
                         ForceData& on_j) override {
    if (contact.contact_flags) {
      *contact.contact_flags |= CONTACT_TANGENTIAL_MODEL;
    }
    if (history_ < 0) {
      return;
    }
    double const slip_speed[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
    double f[3];
    law_.force(contact.contact_history + history_, contact.en, slip_speed, update->dt, contact.Fn,
               contact.meff, contact.computeflag && contact.shearupdate, f);
    double const* const n = contact.en;
    double const moment[3] = {n[1] * f[2] - n[2] * f[1], n[2] * f[0] - n[0] * f[2],
                              n[0] * f[1] - n[1] * f[0]};
    for (int k = 0; k < 3; ++k) {
      on_i.delta_F[k] += f[k];
      on_i.delta_torque[k] = -contact.cri * moment[k];
      if (!contact.is_wall) {
        on_j.delta_F[k] -= f[k];
        on_j.delta_torque[k] = -contact.crj * moment[k];
      }
    }
  }
  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    if (contact.contact_flags) {
      *contact.contact_flags &= ~CONTACT_TANGENTIAL_MODEL;
    }
    for (int k = 0; k < 3 && history_ >= 0; ++k) {
      contact.contact_history[history_ + k] = 0;
    }
  }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  slidewave::dem::CoulombSlider law_;
  int history_ = -1;
};

}  // namespace LIGGGHTS::ContactModels
