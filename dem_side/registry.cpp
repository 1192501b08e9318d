#include "registry.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "contact_styles.h"
#include "expose.h"
#include "fix_contact_memory.h"
#include "fix_fluid_work.h"
#include "fix_slidewave.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "universe.h"

using LAMMPS_NS::Fix;
using LAMMPS_NS::Input;
using LAMMPS_NS::LAMMPS;
using LAMMPS_NS::Modify;

namespace slidewave::dem {

using FixMap = std::map<std::string, Fix* (*)(LAMMPS*, int, char**)>;
using CommandMap = std::map<std::string, void (*)(LAMMPS*, int, char**)>;

struct FixMapTag {
  using type = FixMap* Modify::*;
  friend type get(FixMapTag);
};

struct CommandMapTag {
  using type = CommandMap* Input::*;
  friend type get(CommandMapTag);
};

struct LineTag {
  using type = char* Input::*;
  friend type get(LineTag);
};

template struct Expose<FixMapTag, &Modify::fix_map>;
template struct Expose<CommandMapTag, &Input::command_map>;
template struct Expose<LineTag, &Input::line>;

namespace {

FixMap& fix_map(LAMMPS& lmp) {
  return *(lmp.modify->*get(FixMapTag{}));
}

template <class Style>
Fix* create(LAMMPS* lmp, int argument_count, char** arguments) {
  return new Style(lmp, argument_count, arguments);
}

void (*refuse_command)(char const*) = nullptr;
void (*stock_run)(LAMMPS*, int, char**) = nullptr;

void guarded_run(LAMMPS* lmp, int argument_count, char** arguments) {
  if (argument_count < 1 || std::atol(arguments[0]) != 0) {
    refuse_command("run");
  }
  stock_run(lmp, argument_count, arguments);
}

void refused_minimize(LAMMPS*, int, char**) {
  refuse_command("minimize");
}
void refused_rerun(LAMMPS*, int, char**) {
  refuse_command("rerun");
}

}  // namespace

void register_styles(LAMMPS& lmp) {
  // One error in five of a PUBLIC version is replaced by a joke, from memory already freed.
  if (char* const edition = std::strstr(lmp.universe->version, "PUBLIC")) {
    std::copy_n("public", 6, edition);
  }
  register_contact_styles();
  fix_map(lmp)["slidewave"] = &create<LAMMPS_NS::FixSlidewave>;
  fix_map(lmp)["slidewave/work"] = &create<LAMMPS_NS::FixFluidWork>;
  fix_map(lmp)["slidewave/contacts"] = &create<LAMMPS_NS::FixContactMemory>;
}

bool styles_registered(LAMMPS& lmp) {
  return fix_map(lmp).count("slidewave") > 0;
}

void guard_run_commands(LAMMPS& lmp, void (*refuse)(char const*)) {
  CommandMap& commands = *(lmp.input->*get(CommandMapTag{}));
  refuse_command = refuse;
  stock_run = commands["run"];
  commands["run"] = &guarded_run;
  commands["minimize"] = &refused_minimize;
  commands["rerun"] = &refused_rerun;
}

char const* last_script_line(LAMMPS& lmp) {
  char const* line = lmp.input ? lmp.input->*get(LineTag{}) : nullptr;
  return line ? line : "";
}

}  // namespace slidewave::dem
