#include "script_scan.h"

#include <fstream>
#include <set>
#include <sstream>

namespace slidewave::dem {
namespace {

namespace fs = std::filesystem;

bool writes_vtk(std::string const& dump_style) {
  return dump_style.find("vtk") != std::string::npos || dump_style.find("vtm") != std::string::npos;
}

ForbiddenCommand scan(fs::path const& script, fs::path const& folder, std::set<fs::path>& seen) {
  std::ifstream in(script);
  if (!in || !seen.insert(fs::weakly_canonical(script)).second) {
    return {};
  }
  std::string line;
  int number = 0;
  while (std::getline(in, line)) {
    int const first = ++number;
    std::string next;
    while (!line.empty() && line.back() == '&' && std::getline(in, next)) {
      line.back() = ' ';
      line += next;
      ++number;
    }
    std::istringstream words(line.substr(0, line.find('#')));
    std::string command;
    std::string name;
    std::string group;
    std::string style;
    words >> command >> name >> group >> style;
    if (command == "dump" && writes_vtk(style)) {
      return {script, first, "dump " + style};
    }
    if (command == "clear") {
      return {script, first, command};
    }
    if (command == "include") {
      ForbiddenCommand found = scan(folder / name, folder, seen);
      if (!found.command.empty()) {
        return found;
      }
    }
  }
  return {};
}

}  // namespace

ForbiddenCommand find_forbidden(fs::path const& script, fs::path const& folder) {
  std::set<fs::path> seen;
  return scan(script, folder, seen);
}

}  // namespace slidewave::dem
