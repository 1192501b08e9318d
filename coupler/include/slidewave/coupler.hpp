// The whole public API of the coupling library.
//
//   Session session(Role::fluid, directory);   // first line of main: joins the other program
//   MyEngine engine(session.comm(), session.scene());
//   session.state("gravity", "0 0 -9.81");      // facts both sides must agree about
//   return run(session, engine);               // handshake, windows, budgets, leave
//
// One window, serial order (fluid first; concurrently it answers before it advances; docs/tour.md):
//   particles: gather -> send          receive -> apply -> advance
//   fluid:        collect -> place -> deposit -> exchange -> advance -> sample -> answer
#pragma once

#include <mpi.h>

#include <filesystem>
#include <memory>
#include <string>

#include "slidewave/engine.hpp"
#include "slidewave/scene.hpp"
#include "slidewave/table.hpp"

namespace slidewave {

enum class Role { fluid, dem };

/// Version of the library and of the protocol, compared in the handshake.
std::string version();

/// This process's membership in the run. Owns MPI: initialises it where nobody has, splits the
/// world by role, and ends both programs with one reason where anything fails.
class Session {
 public:
  /// Joins. A role that the case needs and nobody has is refused within 10 s, naming it.
  Session(Role role, std::filesystem::path const& run_directory);
  ~Session();
  Session(Session const&) = delete;

  Role role() const;
  Scene const& scene() const;
  MPI_Comm comm() const;  ///< the communicator of this role; engines use nothing else
  int rank() const;       ///< in comm()
  int size() const;
  bool has_partner() const;  ///< false in a dry scene (fluid.engine = "none")

  /// States a fact, e.g. ("end_time", "50"). Facts stated by both sides must agree (numbers within
  /// 1e-9); each mismatch is a row in one table, and the run is refused.
  void state(std::string const& fact, std::string const& value);
  /// A line on the user's terminal, from the first rank of the role only.
  void say(std::string const& line) const;
  /// Prints the reason, records it in DIR/failure.txt and ends both programs.
  [[noreturn]] void fail(std::string const& reason, int status = 1) const;
  /// Leaves cleanly after both sides are done; called by run().
  void leave();

  struct Impl;
  Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// Runs an engine from handshake to the end of the case. Gives the exit status.
int run(Session& session, FluidEngine& engine);
int run(Session& session, ParticleEngine& engine);

/// Runs `body` and turns every exception into Session::fail (status 2 for InputError).
int guarded(Session& session, int (*body)(Session&));

}  // namespace slidewave
