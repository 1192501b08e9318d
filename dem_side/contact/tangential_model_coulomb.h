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
    double const slip_speed[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
    double* const s = contact.contact_history + history_;
    double const before[3] = {s[0], s[1], s[2]};
    double f[3];
    double const lost_J =
        law_.force(s, contact.en, slip_speed, update->dt, contact.Fn, contact.meff, advance, f);
    double const* const n = contact.en;
    double const moment[3] = {n[1] * f[2] - n[2] * f[1], n[2] * f[0] - n[0] * f[2],
                              n[0] * f[1] - n[1] * f[0]};
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
  // LIGGGHTS may drop the spring of a contact that opens: what the springs lack of the work done on
  // them is heat.
  void book(SurfacesIntersectData const& contact, double const* before, double const* after,
            double const* f, double lost_J) const {
    slidewave::dem::WallBooks& books = slidewave::dem::wall_books();
    auto const square = [](double const* s) { return s[0] * s[0] + s[1] * s[1] + s[2] * s[2]; };
    books.now.tangential += 0.5 * law_.ks * square(after);
    if (contact.shearupdate) {
      books.stored.tangential += 0.5 * law_.ks * (square(after) - square(before)) + lost_J;
      for (int k = 0; k < 3; ++k) {
        books.work += f[k] * contact.v_j[k] * update->dt;
      }
    }
  }

  slidewave::dem::CoulombSlider law_;
  int history_ = -1;
};

}  // namespace LIGGGHTS::ContactModels
