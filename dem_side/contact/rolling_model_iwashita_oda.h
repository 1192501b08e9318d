// rolling_friction iwashita_oda kr K eta H: Iwashita & Oda 1998 (rolling_laws.h) for pairs and
// walls, kr in N m/rad. kr 0 means no resistance: no history is kept.
#pragma once

#include "model_ids.h"
#include "model_settings.h"
#include "rolling_history.h"

namespace LIGGGHTS::ContactModels {

template <>
class RollingModel<slidewave::dem::iwashita_oda_id> : public RollingModelBase {
 public:
  RollingModel(LAMMPS* lammps, IContactHistorySetup* setup, ContactModelBase* model)
      : RollingModelBase(lammps, setup, model) {}

  void registerSettings(Settings& settings) override {
    settings.registerDoubleSetting("kr", law_.kr, slidewave::dem::not_given);
    settings.registerDoubleSetting("eta", law_.eta, slidewave::dem::not_given);
  }
  void postSettings(IContactHistorySetup* setup, ContactModelBase*) override {
    if (law_.kr > 0) {
      history_.keep(*setup, false);
    }
  }
  void connectToProperties(PropertyRegistry&) override {
    slidewave::dem::need_not_negative(*error, "iwashita_oda", "kr", law_.kr, "in N m/rad");
    if (law_.kr > 0) {
      slidewave::dem::need_positive(*error, "iwashita_oda", "eta", law_.eta,
                                    "(kr without a limit moment would never yield)");
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
    history_.act(contact, update->dt, law_.rolling(contact.Fn, reduced_m), {}, on_i, on_j);
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
  slidewave::dem::IwashitaOda law_;
  slidewave::dem::RollingHistory history_;
};

}  // namespace LIGGGHTS::ContactModels
