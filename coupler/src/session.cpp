#include <fmt/format.h>

#include <thread>

#include "crash.hpp"
#include "session_impl.hpp"
#include "signals.hpp"

namespace slidewave {
namespace {

int true_rank() {
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

Scene read_scene(std::filesystem::path const& directory, Failure const& failure) {
  if (true_rank() == 0) {
    failure.forget_earlier();
  }
  try {
    return Scene(directory);
  } catch (InputError const& error) {
    if (true_rank() > 0) {  // every process meets the same error: let the first one speak
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
    }
    failure.fail(error.what(), 2);
  }
}

World join(Role role, Scene const& scene, Waiter& waiter, Failure const& failure) {
  try {
    waiter.patience(scene.number("coupling.patience", 600));
    std::string const partner = role == Role::fluid ? "dem" : "fluid";
    bool const wanted = scene.text(partner + ".engine", "default") != "none";
    return World::join(role, wanted, waiter, failure);
  } catch (std::exception const& error) {
    failure.fail(error.what(), 2);
  }
}

}  // namespace

std::string version() {
  return SLIDEWAVE_VERSION;
}

Session::Impl::Impl(Role as, std::filesystem::path const& directory)
    : role(as),
      start_s(now_s()),
      failure(std::filesystem::absolute(directory), name_of(as)),
      waiter(failure, profile, 600),
      finalises_mpi(start_mpi(as)),
      scene(read_scene(directory, failure)),
      world(join(as, scene, waiter, failure)),
      agreement(world, waiter, as) {
  failure.rename(fmt::format("{} rank {} of {}", name_of(role), world.rank, world.size));
  report_crashes(std::filesystem::absolute(directory) / "failure.txt", failure.who());
  waiter.speaks(is_root());
  watch_signals();  // a wish to stop during set-up is kept for the first window
}

Session::Impl::~Impl() {
  int finalised = 0;
  MPI_Finalized(&finalised);
  if (!finalised && left) {
    world.free();
    failure.stand_down();
    if (finalises_mpi) {
      PMPI_Finalize();
    }
  }
}

void Session::Impl::say(std::string const& line) const {
  if (is_root()) {
    failure.terminal().say(line);
  }
}

Session::Session(Role role, std::filesystem::path const& run_directory)
    : impl_(std::make_unique<Impl>(role, run_directory)) {}

Session::~Session() {
  if (!impl_->left) {
    impl_->failure.fail("the program ended before the run was over", 1);
  }
}

Role Session::role() const {
  return impl_->role;
}
Scene const& Session::scene() const {
  return impl_->scene;
}
MPI_Comm Session::comm() const {
  return impl_->world.engine;
}
int Session::rank() const {
  return impl_->world.rank;
}
int Session::size() const {
  return impl_->world.size;
}
bool Session::has_partner() const {
  return impl_->world.has_partner();
}

void Session::state(std::string const& fact, std::string const& value) {
  impl_->facts.push_back({fact, value});
}

void Session::say(std::string const& line) const {
  impl_->say(line);
}

void Session::fail(std::string const& reason, int status) const {
  impl_->failure.fail(reason, status);
}

void Session::leave() {
  double nothing = 0;
  impl_->agreement.sum_all(&nothing, 1, "both sides to leave");
  impl_->left = true;
}

int guarded(Session& session, int (*body)(Session&)) {
  try {
    return body(session);
  } catch (InputError const& error) {
    session.fail(error.what(), 2);
  } catch (std::exception const& error) {
    session.fail(error.what(), 1);
  } catch (...) {
    session.fail("an exception of unknown type", 1);
  }
}

}  // namespace slidewave
