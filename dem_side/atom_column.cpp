#include "atom_column.h"

#include <cstdio>

#include "atom.h"
#include "fix_property_atom.h"
#include "lammps.h"
#include "modify.h"

namespace slidewave::dem {

LAMMPS_NS::FixPropertyAtom* add_atom_column(LAMMPS_NS::LAMMPS& lmp, std::string const& name,
                                            std::vector<double> const& initial) {
  std::string const id = "slidewave_" + name;
  std::vector<std::string> words = {
      id, "all", "property/atom", id, initial.size() > 1 ? "vector" : "scalar", "yes", "no", "no"};
  for (double const value : initial) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.17g", value);
    words.emplace_back(text);
  }
  std::vector<char*> arguments;
  arguments.reserve(words.size());
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  auto* const column = lmp.modify->add_fix_property_atom(static_cast<int>(arguments.size()),
                                                         arguments.data(), "slidewave");
  if (!column->recent_restart) {
    column->pre_set_arrays();
    for (int i = 0; i < lmp.atom->nlocal; ++i) {
      column->set_arrays(i);
    }
  }
  column->just_created = 0;  // or the next set-up would set all values back
  return column;
}

}  // namespace slidewave::dem
