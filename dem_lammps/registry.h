// What slidewave adds to LAMMPS from outside: its fix, a guard on the run command, and a memory of
// what a script said to those stock fixes whose headers are not packaged.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::lammps {

/// Makes fix slidewave known. Call right after the LAMMPS constructor; `clear` forgets it.
void register_styles(LAMMPS_NS::LAMMPS& lmp);

/// False once a script said `clear`.
bool styles_registered(LAMMPS_NS::LAMMPS& lmp);

/// From now on `run N` with N > 0, `minimize` and `rerun` in a script call `refuse`, which must not
/// return. A set-up script must not advance time: the windows are run by the engine.
void guard_run_commands(LAMMPS_NS::LAMMPS& lmp, void (*refuse)(char const* command));
/// The engine's own runs pass.
void allow_run_commands();

/// The words of the command that made a fix of style setforce or gravity (ID first); else none.
std::vector<std::string> words_of_fix(std::string const& id);

}  // namespace slidewave::lammps
