// model linear kn K [damping zeta] [attraction on|off]: linear_spring.h for pairs and walls.
// kn in N/m; damping, a fraction of critical, is 0 if not given.
#pragma once

#include "contact_models.h"
#include "linear_spring.h"
#include "model_ids.h"
#include "model_settings.h"

namespace LIGGGHTS::ContactModels {

template <>
class NormalModel<slidewave::dem::linear_id> : public NormalModelBase {
 public:
  NormalModel(LAMMPS* lammps, IContactHistorySetup* setup, ContactModelBase* model)
      : NormalModelBase(lammps, setup, model) {}

  void registerSettings(Settings& settings) override {
    settings.registerDoubleSetting("kn", law_.kn, slidewave::dem::not_given);
    settings.registerDoubleSetting("damping", law_.zeta, 0);
    settings.registerOnOff("attraction", law_.attraction, false);
  }
  void postSettings(IContactHistorySetup*, ContactModelBase*) override {}
  void connectToProperties(PropertyRegistry&) override {
    slidewave::dem::need_positive(*error, "linear", "kn", law_.kn, "in N/m");
    slidewave::dem::need(*error, law_.zeta >= 0 && law_.zeta < 1, "linear", "damping", law_.zeta,
                         "a fraction of critical damping, 0 to 1");
  }
  double stressStrainExponent() override { return 1; }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    if (contact.contact_flags) {
      *contact.contact_flags |= CONTACT_NORMAL_MODEL;
    }
    contact.kn = law_.kn;
    contact.Fn = law_.force(contact.deltan, contact.vn, contact.meff);
    for (int k = 0; k < 3; ++k) {
      on_i.delta_F[k] = contact.Fn * contact.en[k];
      on_j.delta_F[k] = -on_i.delta_F[k];
    }
  }
  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    if (contact.contact_flags) {
      *contact.contact_flags &= ~CONTACT_NORMAL_MODEL;
    }
  }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  slidewave::dem::LinearSpring law_;
};

}  // namespace LIGGGHTS::ContactModels
