// ESyS-Particle's world. Its libraries have MPI_COMM_WORLD built in, with rank 0 as the master that
// runs the Python script and the others as workers. The executable brings its own versions of the
// MPI calls that they make: the world that they see is the session's communicator.
//
// A worker waits for the master's next command in MPI_Bcast. So that it can leave for the coupler
// between windows, every broadcast of the master is announced by a message that says either "a
// broadcast follows" or "leave": the worker then runs `on_leave`, and waits again when it returns.
#pragma once

#include <filesystem>
#include <functional>

#include "slidewave/coupler.hpp"

namespace slidewave::esys {

/// From now on ESyS' world is session.comm(). Its MPI_Abort leads to Session::fail.
void enter_world(Session const& session);
/// Worker: what to do when the master lets it go.
void on_leave(std::function<void()> leave);
/// Master: lets the workers leave.
void let_workers_leave();

}  // namespace slidewave::esys
