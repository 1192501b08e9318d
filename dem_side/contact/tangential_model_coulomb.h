// tangential coulomb for walls: coulomb_slider.h (keywords: law_settings.h). A wall's mu is its
// own. With mu = 0 there is no force, and no history is kept.
#pragma once

#include "contact_books.h"
#include "contact_models.h"
#include "contact_scale.h"
#include "law_settings.h"
#include "model_ids.h"
#include "update.h"

namespace LIGGGHTS::ContactModels {

template <>
class TangentialModel<slidewave::dem::coulomb_id> : public TangentialModelBase {
 public:
  TangentialModel(LAMMPS* lammps, IContactHistorySetup* setup, ContactModelBase* model)
      : TangentialModelBase(lammps, setup, model) {}

  void registerSettings(Settings& settings) override {
    slidewave::dem::read_coulomb(settings, law_);
  }
  void postSettings(IContactHistorySetup* setup, ContactModelBase*) override {
    slidewave::dem::scale_stiffness(law_.ks);
    if (law_.mu > 0) {
      history_ = setup->add_history_value("slip_x", "1");
      setup->add_history_value("slip_y", "1");
      setup->add_history_value("slip_z", "1");
    }
  }
  void connectToProperties(PropertyRegistry&) override { slidewave::dem::check(*error, law_); }

  void surfacesIntersect(SurfacesIntersectData const& contact, ForceData& on_i,
                         ForceData&) override {
    if (history_ < 0) {
      return;
    }
    bool const advance = contact.computeflag && contact.shearupdate;
    Vec4 const slip_speed{contact.vtr1, contact.vtr2, contact.vtr3, 0};
    Vec4 const n = slidewave::dem::load3(contact.en);
    Vec4 const before = slidewave::dem::load3(contact.contact_history + history_);
    Vec4 s = before;
    Vec4 f;
    double const lost_J =
        law_.force(s, n, slip_speed, update->dt, contact.Fn, contact.meff, advance, f);
    slidewave::dem::store3(s, contact.contact_history + history_);
    Vec4 const moment = slidewave::dem::cross(n, f);
    for (int k = 0; k < 3; ++k) {
      on_i.delta_F[k] += f[k];
      on_i.delta_torque[k] = -contact.cri * moment[k];
    }
    if (contact.computeflag) {
      book(contact, before, s, f, lost_J);
    }
  }
  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    for (int k = 0; k < 3 && history_ >= 0; ++k) {
      contact.contact_history[history_ + k] = 0;
    }
  }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  using Vec4 = slidewave::dem::Vec4;

  // LIGGGHTS may drop the spring of a contact that opens: what the springs lack of the work done on
  // them is heat.
  void book(SurfacesIntersectData const& contact, Vec4 const& before, Vec4 const& after,
            Vec4 const& f, double lost_J) const {
    slidewave::dem::WallBooks& books = slidewave::dem::wall_books();
    double const kept_J = 0.5 * law_.ks * slidewave::dem::dot(after, after);
    books.now.tangential += kept_J;
    if (contact.shearupdate) {
      books.stored.tangential +=
          kept_J - 0.5 * law_.ks * slidewave::dem::dot(before, before) + lost_J;
      for (int k = 0; k < 3; ++k) {
        books.work += f[k] * contact.v_j[k] * update->dt;
      }
    }
  }

  slidewave::dem::CoulombSlider law_;
  int history_ = -1;
};

}  // namespace LIGGGHTS::ContactModels
