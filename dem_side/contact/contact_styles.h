// Makes our contact laws known to LIGGGHTS, for pairs and for primitive and mesh walls. Each
// combination that is registered is compiled as a kernel of its own:
//
//   linear
//   linear + coulomb
//   linear + coulomb + jiang
//   linear + coulomb + iwashita_oda
#pragma once

namespace slidewave::dem {

/// Once a process, before a script uses the laws. Calling it again does nothing.
void register_contact_styles();

}  // namespace slidewave::dem
