// The processes of a run and how they are joined: by role, never by MPI_APPNUM.
#pragma once

#include <mpi.h>

#include "slidewave/coupler.hpp"
#include "wait.hpp"

namespace slidewave {

char const* name_of(Role role);
inline Role other(Role role) {
  return role == Role::fluid ? Role::dem : Role::fluid;
}

/// Initialises MPI where nobody has. A launcher that waits for a program that never comes is ended
/// after 10 s. Gives true if MPI was initialised here (and is to be finalised here).
bool start_mpi(Role role);

struct World {
  MPI_Comm all = MPI_COMM_NULL;     ///< both sides, the library's own
  MPI_Comm side = MPI_COMM_NULL;    ///< this role, the library's own
  MPI_Comm inter = MPI_COMM_NULL;   ///< ranks are those of the partner
  MPI_Comm engine = MPI_COMM_NULL;  ///< this role, for the engine
  int rank = 0;
  int size = 1;
  int partner_size = 0;

  bool has_partner() const { return inter != MPI_COMM_NULL; }
  /// Splits the true world. `partner_expected` as the case says; a missing or unexpected role is
  /// refused, naming it, and so is a program that does not answer within 10 s.
  static World join(Role role, bool partner_expected, Waiter& waiter, Failure const& failure);
  void free();
};

}  // namespace slidewave
