// rolling_friction jiang for walls: rolling_laws.h (keywords: law_settings.h). shape 0 means no
// resistance: no history is kept. Twisting needs tangential coulomb.
#pragma once

#include "contact_scale.h"
#include "law_settings.h"
#include "model_ids.h"
#include "rolling_history.h"

namespace LIGGGHTS::ContactModels {

template <>
class RollingModel<slidewave::dem::jiang_id> : public RollingModelBase {
 public:
  RollingModel(LAMMPS* lammps, IContactHistorySetup* setup, ContactModelBase* model)
      : RollingModelBase(lammps, setup, model) {}

  void registerSettings(Settings& settings) override {
    slidewave::dem::read_jiang(settings, law_, twist_);
    settings.registerDoubleSetting("ks", ks_, slidewave::dem::not_given);
    settings.registerDoubleSetting("mu", mu_, slidewave::dem::not_given);
  }
  void postSettings(IContactHistorySetup* setup, ContactModelBase*) override {
    slidewave::dem::scale_stiffness(ks_);
    if (law_.shape > 0) {
      history_.keep(*setup, twist_);
    }
  }
  void connectToProperties(PropertyRegistry&) override { slidewave::dem::check(*error, law_); }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i, ForceData&) override {
    if (!history_.kept()) {
      return;
    }
    double const reduced_m = slidewave::dem::reduced_radius(contact.radi, 0, true);
    slidewave::dem::RotationSpring const twisting =
        twist_ ? law_.twisting(ks_, mu_, contact.Fn, reduced_m) : slidewave::dem::RotationSpring{};
    history_.act(contact, update->dt, law_.rolling(contact.kn, contact.Fn, reduced_m), twisting,
                 on_i);
  }
  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
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
