// A fresh LIGGGHTS scene on all ranks, driven line by line.
#pragma once

#include <mpi.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "atom.h"
#include "input.h"
#include "lammps.h"
#include "registry.h"

class SmallScene {
 public:
  /// What LIGGGHTS says is in small_scene.log of the working directory.
  SmallScene() {
    if (!instance()) {
      char words[][16] = {"test", "-screen", "small_scene.log", "-log", "none"};
      char* arguments[] = {words[0], words[1], words[2], words[3], words[4]};
      instance() = new LAMMPS_NS::LAMMPS(5, arguments, MPI_COMM_WORLD);
    } else {
      instance()->input->one("clear");
    }
    lmp_ = instance();
    slidewave::dem::register_styles(*lmp_);
  }

  void lines(std::vector<std::string> const& commands) {
    for (std::string const& command : commands) {
      lmp_->input->one(command.c_str());
    }
  }

  /// Box of side 10 m from the origin, one type; `boundary` e.g. "f f f". No contacts.
  void box(std::string const& boundary) {
    lines({"units si", "atom_style granular", "atom_modify map array sort 0 0",
           "boundary " + boundary, "newton off", "communicate single vel yes", "processors * 1 1",
           "region box block 0 10 0 10 0 10 units box", "create_box 1 box", "neighbor 0.1 bin",
           "neigh_modify delay 0"});
  }

  /// Contact laws as LIGGGHTS wants them: names first, constants last.
  struct Law {
    std::string names;
    std::string constants;
    /// From any order, e.g. "model linear kn 1e6 tangential coulomb ks 1e6 mu 0.5".
    explicit Law(std::string const& text) {
      std::istringstream words(text);
      for (std::string key, value; words >> key >> value;) {
        bool const name = key == "model" || key == "tangential" || key == "rolling_friction";
        (name ? names : constants) += " " + key + " " + value;
      }
    }
  };
  void law(std::string const& text) {
    Law const law(text);
    lines(
        {"atom_modify sort 50 0", "pair_style gran" + law.names + law.constants, "pair_coeff * *"});
  }
  /// A wall with a law of its own; `shape` e.g. "primitive type 1 zplane 0".
  void wall(std::string const& name, std::string const& text, std::string const& shape) {
    Law const law(text);
    lines({"fix " + name + " all wall/gran" + law.names + " " + shape + law.constants});
  }

  /// Packaged linear contacts, kn and kt in N/m, no damping.
  void contacts(double kn, double kt, double friction) {
    auto const number = [](double value) { return " " + std::to_string(value); };
    lines({"fix kn all property/global kn peratomtypepair 1" + number(kn),
           "fix kt all property/global kt peratomtypepair 1" + number(kt),
           "fix gn all property/global gamman peratomtypepair 1 0",
           "fix gt all property/global gammat peratomtypepair 1 0",
           "fix mu all property/global coefficientFriction peratomtypepair 1" + number(friction),
           "atom_modify sort 50 0", "pair_style gran model hooke/stiffness tangential history",
           "pair_coeff * *"});
  }

  /// One sphere of density 2650 kg/m3; ids count from 1.
  void sphere(double x, double y, double z, double diameter_m) {
    ++count_;
    std::string const id = std::to_string(count_);
    lines({"create_atoms 1 single " + std::to_string(x) + " " + std::to_string(y) + " " +
               std::to_string(z) + " units box",
           "group new id " + id,
           "set group new diameter " + std::to_string(diameter_m) + " density 2650",
           "group new delete"});
  }

  LAMMPS_NS::LAMMPS& lmp() { return *lmp_; }

  /// What `value(local index)` gives on the rank that holds atom `id`, on all ranks.
  template <class Value>
  double of_atom(int id, Value const& value) {
    double sums[2] = {0, 0};
    for (int i = 0; i < lmp_->atom->nlocal; ++i) {
      if (lmp_->atom->tag[i] == id) {
        sums[0] = value(i);
        sums[1] = 1;
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sums[1] == 1 ? sums[0] : std::nan("");
  }
  double x(int id, int axis) {
    return of_atom(id, [&](int i) { return lmp_->atom->x[i][axis]; });
  }
  void set_velocity(int id, std::string const& xyz) {
    lines({"group moved id " + std::to_string(id), "velocity moved set " + xyz + " units box",
           "group moved delete"});
  }
  void set_spin(int id, double x, double y, double z) {
    for (int i = 0; i < lmp_->atom->nlocal; ++i) {
      if (lmp_->atom->tag[i] == id) {
        lmp_->atom->omega[i][0] = x;
        lmp_->atom->omega[i][1] = y;
        lmp_->atom->omega[i][2] = z;
      }
    }
  }
  double v(int id, int axis) {
    return of_atom(id, [&](int i) { return lmp_->atom->v[i][axis]; });
  }
  double omega(int id, int axis) {
    return of_atom(id, [&](int i) { return lmp_->atom->omega[i][axis]; });
  }
  double mass(int id) {
    return of_atom(id, [&](int i) { return lmp_->atom->rmass[i]; });
  }

 private:
  // One a process, never deleted: a second one would register LIGGGHTS' contact models twice.
  static LAMMPS_NS::LAMMPS*& instance() {
    static LAMMPS_NS::LAMMPS* lmp = nullptr;
    return lmp;
  }

  LAMMPS_NS::LAMMPS* lmp_ = nullptr;
  int count_ = 0;
};
