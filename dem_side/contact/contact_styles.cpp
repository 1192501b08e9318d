#include "contact_styles.h"

// LIGGGHTS' stub headers lack include guards: this order, and this file only.
// clang-format off
#include "fix_insert_stream.h"
#include "contact_models.h"
#include "pair_gran_base.h"
#include "fix_wall_gran.h"
#include "fix_wall_gran_base.h"
// clang-format on

#include "model_settings.h"
#include "normal_model_linear.h"
#include "pair_style.h"
#include "rolling_model_iwashita_oda.h"
#include "rolling_model_jiang.h"
#include "tangential_model_coulomb.h"

namespace slidewave::dem {
namespace {

namespace models = LIGGGHTS::ContactModels;

template <int tangential, int rolling>
using Style = models::GranStyle<linear_id, tangential, models::COHESION_OFF, rolling,
                                models::SURFACE_DEFAULT>;

// LIGGGHTS' view of OwnPairs.
template <int tangential, int rolling>
class PairStyle : public LIGGGHTS::PairStyles::IGranularPairStyle {
 public:
  explicit PairStyle(LAMMPS_NS::LAMMPS& lmp)
      : pairs_(lmp, {tangential == coulomb_id, rolling == jiang_id, rolling == iwashita_oda_id}) {}

  void settings(int count, char** arguments, LIGGGHTS::IContactHistorySetup*) override {
    pairs_.settings(count, arguments);
  }
  void init_granular() override { pairs_.init(); }
  void compute_force(LAMMPS_NS::PairGran* pair, int eflag, int vflag, int) override {
    pairs_.compute(*pair, eflag, vflag);
  }
  void write_restart_settings(FILE* file) override {
    int64_t const code = hashcode();
    std::fwrite(&code, sizeof(code), 1, file);
  }
  void read_restart_settings(FILE*, int64_t) override {}
  int get_history_offset(std::string) override { return -1; }
  double stressStrainExponent() override { return 1; }
  int64_t hashcode() override { return Style<tangential, rolling>::HASHCODE; }
  bool contact_match(std::string kind, std::string model) override {
    models::Factory& names = models::Factory::instance();
    return (kind == "normal" && names.getNormalModelId(model) == linear_id) ||
           (kind == "tangential" && names.getTangentialModelId(model) == tangential) ||
           (kind == "rolling_friction" && names.getRollingModelId(model) == rolling);
  }

 private:
  OwnPairs pairs_;
};

template <int tangential, int rolling>
LIGGGHTS::PairStyles::IGranularPairStyle* new_pair(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGran*,
                                                   int64_t) {
  return new PairStyle<tangential, rolling>(*lmp);
}

// LIGGGHTS' walls with our laws.
template <int tangential, int rolling>
class WallStyle
    : public LIGGGHTS::Walls::Granular<models::ContactModel<Style<tangential, rolling>>> {
  using Base = LIGGGHTS::Walls::Granular<models::ContactModel<Style<tangential, rolling>>>;

 public:
  WallStyle(LAMMPS_NS::LAMMPS* program, LAMMPS_NS::FixWallGran* wall, int64_t hash)
      : Base(program, wall, hash), errors_(*program->error) {}
  void settings(int count, char** arguments, LIGGGHTS::IContactHistorySetup* setup) override {
    check_words(errors_, count, arguments);
    Base::settings(count, arguments, setup);
  }

 private:
  LAMMPS_NS::Error& errors_;
};

template <int tangential, int rolling>
LIGGGHTS::Walls::IGranularWall* new_wall(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::FixWallGran* parent,
                                         int64_t hash) {
  return new WallStyle<tangential, rolling>(lmp, parent, hash);
}

template <int tangential, int rolling>
void add_laws() {
  int64_t const code = Style<tangential, rolling>::HASHCODE;
  LIGGGHTS::PairStyles::Factory::instance().addStyle("gran", code, new_pair<tangential, rolling>);
  LIGGGHTS::Walls::Factory::instance().addStyle("gran", code, new_wall<tangential, rolling>);
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
  add_laws<models::TANGENTIAL_OFF, models::ROLLING_OFF>();
  add_laws<coulomb_id, models::ROLLING_OFF>();
  add_laws<coulomb_id, jiang_id>();
  add_laws<coulomb_id, iwashita_oda_id>();
}

}  // namespace slidewave::dem
