#include "contact_styles.h"

// LIGGGHTS' stub headers lack include guards: this order, and this file only.
// clang-format off
#include "fix_insert_stream.h"
#include "contact_models.h"
#include "pair_gran_base.h"
#include "fix_wall_gran.h"
#include "fix_wall_gran_base.h"
// clang-format on

#include "normal_model_linear.h"
#include "rolling_model_iwashita_oda.h"
#include "rolling_model_jiang.h"
#include "tangential_model_coulomb.h"

namespace slidewave::dem {
namespace {

namespace models = LIGGGHTS::ContactModels;

template <class Style>
LIGGGHTS::PairStyles::IGranularPairStyle* new_pair(LAMMPS_NS::LAMMPS* lmp,
                                                   LAMMPS_NS::PairGran* parent, int64_t hash) {
  return new LIGGGHTS::PairStyles::Granular<models::ContactModel<Style>>(lmp, parent, hash);
}

template <class Style>
LIGGGHTS::Walls::IGranularWall* new_wall(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::FixWallGran* parent,
                                         int64_t hash) {
  return new LIGGGHTS::Walls::Granular<models::ContactModel<Style>>(lmp, parent, hash);
}

template <int tangential, int rolling>
void add_kernel() {
  using Style = models::GranStyle<linear_id, tangential, models::COHESION_OFF, rolling,
                                  models::SURFACE_DEFAULT>;
  LIGGGHTS::PairStyles::Factory::instance().addStyle("gran", Style::HASHCODE, new_pair<Style>);
  LIGGGHTS::Walls::Factory::instance().addStyle("gran", Style::HASHCODE, new_wall<Style>);
}

}  // namespace

void register_contact_styles() {
  static bool done = false;
  if (done) {
    return;
  }
  done = true;
  models::Factory& names = models::Factory::instance();
  names.addNormalModel("linear", linear_id);
  names.addTangentialModel("coulomb", coulomb_id);
  names.addRollingModel("jiang", jiang_id);
  names.addRollingModel("iwashita_oda", iwashita_oda_id);
  add_kernel<models::TANGENTIAL_OFF, models::ROLLING_OFF>();
  add_kernel<coulomb_id, models::ROLLING_OFF>();
  add_kernel<coulomb_id, jiang_id>();
  add_kernel<coulomb_id, iwashita_oda_id>();
}

}  // namespace slidewave::dem
