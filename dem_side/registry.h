// What slidewave adds to LIGGGHTS from outside: fix styles, contact laws and a guard on
// the run command.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace slidewave::dem {

/// Makes our fix styles and contact laws known. Call right after the LAMMPS constructor; `clear`
/// forgets the fixes. Also makes LIGGGHTS' error messages dependable.
void register_styles(LAMMPS_NS::LAMMPS& lmp);

/// False once a script said `clear`.
bool styles_registered(LAMMPS_NS::LAMMPS& lmp);

/// From now on `run N` with N > 0, `minimize` and `rerun` in a script call `refuse`, which must not
/// return. A set-up script must not advance time: the windows are run by the engine.
void guard_run_commands(LAMMPS_NS::LAMMPS& lmp, void (*refuse)(char const* command));

/// The last line that the script reader saw, for error messages; empty where there is none.
char const* last_script_line(LAMMPS_NS::LAMMPS& lmp);

}  // namespace slidewave::dem
