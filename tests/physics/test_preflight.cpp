// A sound scene passes; each way to break it gives one bad row whose remedy, applied, mends it.
#include <gtest/gtest.h>

#include "checks.hpp"
#include "print.hpp"

namespace slidewave::preflight {
namespace {

using nlohmann::json;

/// The quick Vajont scene in round numbers.
json sound() {
  return {{"window_s", 0.02},
          {"end_time_s", 50},
          {"gravity_m_s2", 9.81},
          {"dem_dt_s", 1.6e-3},
          {"coarse_grain", 2},
          {"smoothing_length_m", 15},
          {"particles", 13482},
          {"diameter_min_m", 3.6},
          {"diameter_max_m", 7.6},
          {"particle_density_min_kg_m3", 2650},
          {"stiffness_N_m", 3e9},
          {"column_height_m", 229},
          {"periodic_width_m", 15.2},
          {"speed_m_s", 40},
          {"fluid_density_kg_m3", 1000},
          {"fluid_viscosity_Pa_s", 1e-3},
          {"second_density_kg_m3", 1.225},
          {"fluid_dt_s", 0.02},
          {"cells", 12000},
          {"cell_size_m", 10},
          {"smallest_cell_m", 6},
          {"memory_available_bytes", 8e9}};
}

Sheet examine(json const& values) {
  Facts const facts(values);
  Sheet sheet;
  check_particles(facts, sheet);
  check_coupling(facts, sheet);
  check_fluid(facts, sheet);
  check_cost(facts, sheet);
  check_names(facts, sheet);
  return sheet;
}

Row row_of(Sheet const& sheet, std::string const& quantity) {
  for (auto const& row : sheet.rows()) {
    if (row.quantity == quantity) {
      return row;
    }
  }
  ADD_FAILURE() << "no row " << quantity;
  return {};
}

TEST(Preflight, SoundSceneHasNothingBad) {
  Sheet const sheet = examine(sound());
  EXPECT_FALSE(sheet.any_bad()) << as_table(sheet);
}

struct Breakage {
  char const* fact;
  double value;
  char const* quantity;
  char const* mend;  ///< the fact that the remedy's key stands for
};

TEST(Preflight, EachBreakageIsFoundAndItsRemedyMendsIt) {
  for (Breakage const& broken :
       {Breakage{"dem_dt_s", 4e-3, "particle step [s]", "dem_dt_s"},
        Breakage{"stiffness_N_m", 3e10, "particle step [s]", "dem_dt_s"},
        Breakage{"diameter_min_m", 0.36, "particle step [s]", "dem_dt_s"},
        Breakage{"stiffness_N_m", 1e8, "overlap under the column's weight [D]", "stiffness_N_m"},
        Breakage{"column_height_m", 5e3, "overlap under the column's weight [D]", "stiffness_N_m"},
        Breakage{"speed_m_s", 200, "overlap in the fastest impact [D]", "stiffness_N_m"},
        Breakage{"periodic_width_m", 9, "periodic width [m]", "periodic_width_m"},
        Breakage{"window_s", 2, "cells crossed in a window", "window_s"},
        Breakage{"window_s", 2, "response of the drag in a window, K W/m", "window_s"},
        Breakage{"fluid_viscosity_Pa_s", 1e5, "response of the drag in a window, K W/m",
                 "window_s"},
        Breakage{"particle_density_min_kg_m3", 450, "added-mass number rho_f phi/(rho_s eps)",
                 "particle_density_min_kg_m3"},
        Breakage{"window_s", 0.06, "kernels that a contact wave runs in a window", "window_s"},
        Breakage{"fluid_dt_s", 0.5, "interface Courant number", "fluid_dt_s"},
        Breakage{"cell_size_m", 0.7, "cell size over largest diameter", "cell_size_m"},
        Breakage{"smoothing_length_m", 3, "smoothing length [m]", "smoothing_length_m"}}) {
    json values = sound();
    values[broken.fact] = broken.value;
    Row const row = row_of(examine(values), broken.quantity);
    ASSERT_EQ(row.verdict, "bad") << broken.fact;
    ASSERT_TRUE(row.works.has_value()) << broken.fact;
    EXPECT_FALSE(row.key.empty());
    values[broken.mend] = *row.works * (row.value > row.limit ? 0.999999 : 1.000001);
    if (std::string(broken.mend) == "stiffness_N_m" ||
        std::string(broken.mend) == "particle_density_min_kg_m3") {
      values[broken.mend] = *row.works * 1.000001;
    }
    EXPECT_EQ(row_of(examine(values), broken.quantity).verdict, "ok") << broken.fact;
  }
}

TEST(Preflight, StiffRegimeAdmitsWhatIsProven) {
  json values = sound();
  values["regime"] = "stiff";
  values["fluid_viscosity_Pa_s"] = 1e6;
  EXPECT_EQ(row_of(examine(values), "response of the drag in a window, K W/m").verdict, "ok");
  values["fluid_viscosity_Pa_s"] = 1e13;
  EXPECT_EQ(row_of(examine(values), "response of the drag in a window, K W/m").verdict, "bad");
}

TEST(Preflight, HeldParticlesHaveNoInertia) {
  json values = sound();
  values["particle_density_min_kg_m3"] = 450;
  values["window_s"] = 0.06;
  char const* const rows[] = {"added-mass number rho_f phi/(rho_s eps)",
                              "kernels that a contact wave runs in a window"};
  for (char const* row : rows) {
    EXPECT_EQ(row_of(examine(values), row).verdict, "bad");
  }
  values["held"] = true;
  for (char const* row : rows) {
    EXPECT_EQ(row_of(examine(values), row).verdict, "note");
  }
}

TEST(Preflight, StiffDragDampsWhatTheLagOfTheAddedMassFeeds) {
  json values = sound();
  values["window_s"] = 0.06;
  values["speed_m_s"] = 0.4;
  values["particle_density_min_kg_m3"] = 450;
  for (char const* regime : {"mild", "stiff"}) {
    values["regime"] = regime;
    values["fluid_viscosity_Pa_s"] = 1e-3;  // weak drag damps nothing in either
    EXPECT_EQ(row_of(examine(values), "kernels that a contact wave runs in a window").verdict,
              "bad");
    EXPECT_EQ(row_of(examine(values), "added-mass number rho_f phi/(rho_s eps)").verdict, "bad");
  }
  values["fluid_viscosity_Pa_s"] = 1e6;
  EXPECT_EQ(row_of(examine(values), "kernels that a contact wave runs in a window").verdict,
            "note");
  EXPECT_EQ(row_of(examine(values), "added-mass number rho_f phi/(rho_s eps)").verdict, "bad");
  values["particle_density_min_kg_m3"] = 1100;
  EXPECT_EQ(row_of(examine(values), "added-mass number rho_f phi/(rho_s eps)").verdict, "warn");
  values["particle_density_min_kg_m3"] = 900;
  EXPECT_EQ(row_of(examine(values), "added-mass number rho_f phi/(rho_s eps)").verdict, "bad");
}

/// A slow, loosely packed slide in short windows, which both schemes carry.
json sound_at_once() {
  json values = sound();
  values["scheme"] = "concurrent";
  values["window_s"] = 5e-3;
  values["speed_m_s"] = 20;
  values["second_viscosity_Pa_s"] = 1.8e-5;
  return values;
}

TEST(Preflight, ConcurrentIsRefusedByNumberBeyondItsLimits) {
  std::string const on_fluid = "drag on the fluid of a cell in a window, K W/m_fluid",
                    on_grain = "response of the drag in a window, K W/m",
                    added_mass = "added-mass number rho_f phi/(rho_s eps)",
                    waves = "kernels that a contact wave runs in a window";
  EXPECT_FALSE(examine(sound_at_once()).any_bad()) << as_table(examine(sound_at_once()));
  struct Beyond {
    char const* fact;
    double value;
    std::string quantity;
  };
  for (Beyond const& beyond :
       {Beyond{"fluid_viscosity_Pa_s", 5e3, on_fluid},
        Beyond{"second_viscosity_Pa_s", 10, on_fluid},
        Beyond{"fluid_viscosity_Pa_s", 3e4, on_grain},
        Beyond{"particle_density_min_kg_m3", 2000, added_mass}, Beyond{"window_s", 0.025, waves}}) {
    json values = sound_at_once();
    values[beyond.fact] = beyond.value;
    Row const row = row_of(examine(values), beyond.quantity);
    EXPECT_EQ(row.verdict, "bad") << beyond.fact << "\n" << as_table(examine(values));
    values["scheme"] = "serial";
    bool const known = beyond.quantity != on_fluid && beyond.quantity != on_grain;
    if (known) {
      EXPECT_NE(row_of(examine(values), beyond.quantity).verdict, "bad") << beyond.fact;
    }
    if (row.key == "coupling.window") {
      values["scheme"] = "concurrent";
      values["window_s"] = *row.works * 0.999999;
      EXPECT_EQ(row_of(examine(values), beyond.quantity).verdict, "ok") << beyond.fact;
    }
  }
  json one_way = sound_at_once();
  one_way["two_way"] = false;
  one_way["fluid_viscosity_Pa_s"] = 3e4;
  EXPECT_FALSE(examine(one_way).any_bad());
}

TEST(Preflight, StepThatWorksDividesTheWindow) {
  json values = sound();
  values["dem_dt_s"] = 4e-3;
  double const step = *row_of(examine(values), "particle step [s]").works;
  double const steps = 0.02 / step;
  EXPECT_NEAR(steps, std::round(steps), 1e-9);
}

TEST(Preflight, OneWayNeedsNoMildDragAndNoSmoothing) {
  json values = sound();
  values["two_way"] = false;
  values["fluid_viscosity_Pa_s"] = 1e5;
  Sheet const sheet = examine(values);
  EXPECT_EQ(row_of(sheet, "response of the drag in a window, K W/m").verdict, "warn");
  EXPECT_EQ(row_of(sheet, "smoothing length [m]").verdict, "note");
}

TEST(Preflight, LoneStiffParticleIsNoMixture) {
  json values = sound();
  values["particles"] = 1;
  values["fluid_viscosity_Pa_s"] = 1e5;
  values["smoothing_length_m"] = 150;
  EXPECT_EQ(row_of(examine(values), "response of the drag in a window, K W/m").verdict, "warn");
}

TEST(Preflight, MissingNumbersLeaveTheirRowsOutByName) {
  json values = sound();
  values.erase("stiffness_N_m");
  Row const row = row_of(examine(values), "particle step [s]");
  EXPECT_EQ(row.verdict, "note");
  EXPECT_EQ(row.source, "left out: not known: stiffness_N_m");
  EXPECT_FALSE(examine(json::object()).any_bad());
}

TEST(Preflight, UnknownFactSuggestsTheNearest) {
  json values = sound();
  values["colum_height_m"] = 3;
  EXPECT_NE(row_of(examine(values), "fact colum_height_m").source.find("column_height_m"),
            std::string::npos);
}

TEST(Preflight, WrongTypeIsRefused) {
  json values = sound();
  values["window_s"] = "long";
  EXPECT_THROW(examine(values), InputError);
}

TEST(Preflight, JsonHasAllFieldsAndNulls) {
  json const rows = as_json(examine(json::object()));
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows[0].size(), 8u);
  EXPECT_TRUE(rows[0]["value"].is_null());
  EXPECT_TRUE(as_json(examine(sound()))[0]["margin"].is_number());
}

}  // namespace
}  // namespace slidewave::preflight
