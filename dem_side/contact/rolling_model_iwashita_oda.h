// rolling_friction iwashita_oda for walls: rolling_laws.h (keywords: law_settings.h). kr 0 means no
// resistance: no history is kept.
#pragma once

#include "contact_scale.h"
#include "law_settings.h"
#include "model_ids.h"
#include "rolling_history.h"

namespace LIGGGHTS::ContactModels {

template <>
class RollingModel<slidewave::dem::iwashita_oda_id> : public RollingModelBase {
 public:
  RollingModel(LAMMPS* lammps, IContactHistorySetup* setup, ContactModelBase* model)
      : RollingModelBase(lammps, setup, model) {}

  void registerSettings(Settings& settings) override {
    slidewave::dem::read_iwashita_oda(settings, law_);
  }
  void postSettings(IContactHistorySetup* setup, ContactModelBase*) override {
    slidewave::dem::scale_rotation(law_.kr);
    if (law_.kr > 0) {
      history_.keep(*setup, false);
    }
  }
  void connectToProperties(PropertyRegistry&) override { slidewave::dem::check(*error, law_); }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i, ForceData&) override {
    if (history_.kept()) {
      double const reduced_m = slidewave::dem::reduced_radius(contact.radi, 0, true);
      history_.act(contact, update->dt, law_.rolling(contact.Fn, reduced_m), {}, on_i);
    }
  }
  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    history_.forget(contact);
  }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  slidewave::dem::IwashitaOda law_;
  slidewave::dem::RollingHistory history_;
};

}  // namespace LIGGGHTS::ContactModels
