#include "registry.h"

#include <cstdlib>
#include <map>

#include "fix_slidewave.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"

using LAMMPS_NS::Command;
using LAMMPS_NS::Fix;
using LAMMPS_NS::Input;
using LAMMPS_NS::LAMMPS;
using LAMMPS_NS::Modify;

namespace slidewave::lammps {
namespace {

std::map<std::string, Modify::FixCreator> stock_fix;
std::map<std::string, std::vector<std::string>> said;  // by fix ID
void (*refuse_command)(char const*) = nullptr;
Input::CommandCreator stock_run = nullptr;

Fix* create_ours(LAMMPS* lmp, int argument_count, char** arguments) {
  return new LAMMPS_NS::FixSlidewave(lmp, argument_count, arguments);
}

Fix* create_and_remember(LAMMPS* lmp, int argument_count, char** arguments) {
  said[arguments[0]].assign(arguments, arguments + argument_count);
  return stock_fix.at(arguments[2])(lmp, argument_count, arguments);
}

Command* guarded_run(LAMMPS* lmp) {
  Input const& input = *lmp->input;
  if (refuse_command && (input.narg < 1 || std::atol(input.arg[0]) != 0)) {
    refuse_command("run");
  }
  return stock_run(lmp);
}

template <char const* name>
Command* refused(LAMMPS*) {
  refuse_command(name);
  return nullptr;
}
constexpr char minimize[] = "minimize";
constexpr char rerun[] = "rerun";

}  // namespace

void register_styles(LAMMPS& lmp) {
  Modify::FixCreatorMap& fixes = *lmp.modify->fix_map;
  said.clear();
  for (char const* style : {"setforce", "gravity"}) {
    stock_fix[style] = fixes.at(style);
    fixes[style] = &create_and_remember;
  }
  fixes["slidewave"] = &create_ours;
}

bool styles_registered(LAMMPS& lmp) {
  return lmp.modify->fix_map->count("slidewave") > 0;
}

void guard_run_commands(LAMMPS& lmp, void (*refuse)(char const*)) {
  Input::CommandCreatorMap& commands = *lmp.input->command_map;
  refuse_command = refuse;
  stock_run = commands.at("run");
  commands["run"] = &guarded_run;
  commands[minimize] = &refused<minimize>;
  commands[rerun] = &refused<rerun>;
}

void allow_run_commands() {
  refuse_command = nullptr;
}

std::vector<std::string> words_of_fix(std::string const& id) {
  auto const found = said.find(id);
  return found == said.end() ? std::vector<std::string>() : found->second;
}

}  // namespace slidewave::lammps
