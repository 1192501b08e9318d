// Keywords of the contact laws, read and checked in one place for pairs and walls.
//
//   model linear kn K [damping zeta] [attraction on|off]
//   tangential coulomb ks K mu M [damping_s zeta]
//   rolling_friction jiang shape b crushing zeta_c [twist on|off]
//   rolling_friction iwashita_oda kr K eta H
#pragma once

#include <string>

#include "coulomb_slider.h"
#include "linear_spring.h"
#include "model_settings.h"
#include "rolling_laws.h"
#include "settings.h"

namespace slidewave::dem {

inline void read_linear(Settings& settings, LinearSpring& law) {
  settings.registerDoubleSetting("kn", law.kn, not_given);
  settings.registerDoubleSetting("damping", law.zeta, 0);
  settings.registerOnOff("attraction", law.attraction, false);
}

inline void check(LAMMPS_NS::Error& error, LinearSpring const& law) {
  need_positive(error, "linear", "kn", law.kn, "in N/m");
  need(error, law.zeta >= 0 && law.zeta < 1, "linear", "damping", law.zeta,
       "a fraction of critical damping, 0 to 1");
}

inline void read_coulomb(Settings& settings, CoulombSlider& law) {
  settings.registerDoubleSetting("ks", law.ks, not_given);
  settings.registerDoubleSetting("mu", law.mu, not_given);
  settings.registerDoubleSetting("damping_s", law.zeta, 0);
}

inline void check(LAMMPS_NS::Error& error, CoulombSlider const& law) {
  need_positive(error, "coulomb", "ks", law.ks, "in N/m");
  need_not_negative(error, "coulomb", "mu", law.mu, "");
  need(error, law.zeta >= 0 && law.zeta < 1, "coulomb", "damping_s", law.zeta,
       "a fraction of critical damping, 0 to 1");
}

inline void read_jiang(Settings& settings, Jiang& law, bool& twist) {
  settings.registerDoubleSetting("shape", law.shape, not_given);
  settings.registerDoubleSetting("crushing", law.crushing, not_given);
  settings.registerOnOff("twist", twist, false);
}

inline void check(LAMMPS_NS::Error& error, Jiang const& law) {
  need_not_negative(error, "jiang", "shape", law.shape, "(of the radius)");
  if (law.shape > 0) {
    need_positive(error, "jiang", "crushing", law.crushing, "(it sets the limit moment)");
  }
}

inline void read_iwashita_oda(Settings& settings, IwashitaOda& law) {
  settings.registerDoubleSetting("kr", law.kr, not_given);
  settings.registerDoubleSetting("eta", law.eta, not_given);
}

inline void check(LAMMPS_NS::Error& error, IwashitaOda const& law) {
  need_not_negative(error, "iwashita_oda", "kr", law.kr, "in N m/rad");
  if (law.kr > 0) {
    need_positive(error, "iwashita_oda", "eta", law.eta,
                  "(kr without a limit moment would never yield)");
  }
}

}  // namespace slidewave::dem
