// rolling_friction jiang shape b crushing zeta_c [twist on|off]: Jiang 2015 (rolling_laws.h) for
// pairs and walls. shape 0 means no resistance: no history is kept. Twisting needs tangential
// coulomb.
#pragma once

#include "model_ids.h"
#include "model_settings.h"
#include "rolling_history.h"

namespace LIGGGHTS::ContactModels {

template <>
class RollingModel<slidewave::dem::jiang_id> : public RollingModelBase {
 public:
  RollingModel(LAMMPS* lammps, IContactHistorySetup* setup, ContactModelBase* model)
      : RollingModelBase(lammps, setup, model) {}

  void registerSettings(Settings& settings) override {
    settings.registerDoubleSetting("shape", law_.shape, slidewave::dem::not_given);
    settings.registerDoubleSetting("crushing", law_.crushing, slidewave::dem::not_given);
    settings.registerDoubleSetting("ks", ks_, slidewave::dem::not_given);
    settings.registerDoubleSetting("mu", mu_, slidewave::dem::not_given);
    settings.registerOnOff("twist", twist_, false);
  }
  void postSettings(IContactHistorySetup* setup, ContactModelBase*) override {
    if (law_.shape > 0) {
      history_.keep(*setup, twist_);
    }
  }
  void connectToProperties(PropertyRegistry&) override {
    slidewave::dem::need_not_negative(*error, "jiang", "shape", law_.shape, "(of the radius)");
    if (law_.shape > 0) {
      slidewave::dem::need_positive(*error, "jiang", "crushing", law_.crushing,
                                    "(it sets the limit moment)");
    }
  }
  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    if (!history_.kept()) {
      return;
    }
    if (contact.contact_flags) {
      *contact.contact_flags |= CONTACT_ROLLING_MODEL;
    }
    double const reduced_m =
        slidewave::dem::reduced_radius(contact.radi, contact.radj, contact.is_wall);
    slidewave::dem::RotationSpring const twisting =
        twist_ ? law_.twisting(ks_, mu_, contact.Fn, reduced_m) : slidewave::dem::RotationSpring{};
    history_.act(contact, update->dt, law_.rolling(contact.kn, contact.Fn, reduced_m), twisting,
                 on_i, on_j);
  }
  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    if (contact.contact_flags) {
      *contact.contact_flags &= ~CONTACT_ROLLING_MODEL;
    }
    history_.forget(contact);
  }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  slidewave::dem::Jiang law_;
  slidewave::dem::RollingHistory history_;
  double ks_ = 0;
  double mu_ = 0;
  bool twist_ = false;
};

}  // namespace LIGGGHTS::ContactModels
