// model linear for walls: linear_spring.h (keywords: law_settings.h).
#pragma once

#include "contact_books.h"
#include "contact_models.h"
#include "contact_scale.h"
#include "law_settings.h"
#include "model_ids.h"
#include "update.h"

namespace LIGGGHTS::ContactModels {

template <>
class NormalModel<slidewave::dem::linear_id> : public NormalModelBase {
 public:
  NormalModel(LAMMPS* lammps, IContactHistorySetup* setup, ContactModelBase* model)
      : NormalModelBase(lammps, setup, model) {}

  void registerSettings(Settings& settings) override {
    slidewave::dem::read_linear(settings, law_);
  }
  void postSettings(IContactHistorySetup*, ContactModelBase*) override {
    slidewave::dem::scale_stiffness(law_.kn);
  }
  void connectToProperties(PropertyRegistry&) override { slidewave::dem::check(*error, law_); }
  double stressStrainExponent() override { return 1; }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    contact.kn = law_.kn;
    contact.Fn = law_.force(contact.deltan, contact.vn, contact.meff);
    for (int k = 0; k < 3; ++k) {
      on_i.delta_F[k] = contact.Fn * contact.en[k];
      on_j.delta_F[k] = -on_i.delta_F[k];
    }
    if (contact.computeflag) {
      book(contact);
    }
  }
  void surfacesClose(SurfacesCloseData&, ForceData&, ForceData&) override {}
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  void book(SurfacesIntersectData const& contact) const {
    slidewave::dem::WallBooks& books = slidewave::dem::wall_books();
    double const elastic_N = law_.kn * contact.deltan;
    books.now.normal += 0.5 * elastic_N * contact.deltan;
    if (contact.shearupdate) {
      double const* const n = contact.en;
      double const wall_m_s = contact.v_j[0] * n[0] + contact.v_j[1] * n[1] + contact.v_j[2] * n[2];
      books.damping += (elastic_N - contact.Fn) * contact.vn * update->dt;
      books.work += contact.Fn * wall_m_s * update->dt;
    }
  }

  slidewave::dem::LinearSpring law_;
};

}  // namespace LIGGGHTS::ContactModels
