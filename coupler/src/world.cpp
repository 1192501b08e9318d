#include "world.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

namespace slidewave {
namespace {

constexpr double join_deadline_s = 10;
constexpr int magic = 0x51de;  // with the role added: what a program with this library answers

/// Ends the process if it is not disarmed in time. Makes no MPI call: MPI is not up yet.
class StartGuard {
 public:
  explicit StartGuard(Role role)
      : thread_([this, role] {
          std::unique_lock<std::mutex> lock(mutex_);
          auto const deadline = std::chrono::duration<double>(join_deadline_s);
          if (!disarmed_.wait_for(lock, deadline, [this] { return done_; })) {
            Terminal().complain(fmt::format(
                "slidewave: {}: MPI did not start within {:.0f} s: was slidewave_{} started in the "
                "same mpirun?",
                name_of(role), join_deadline_s, role == Role::fluid ? "dem" : "foam"));
            std::_Exit(2);
          }
        }) {}
  ~StartGuard() {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      done_ = true;
    }
    disarmed_.notify_all();
    thread_.join();
  }

 private:
  std::mutex mutex_;
  std::condition_variable disarmed_;
  bool done_ = false;
  std::thread thread_;
};

std::vector<int> gather_roles(Role role, Waiter& waiter) {
  int size = 0;
  PMPI_Comm_size(MPI_COMM_WORLD, &size);
  int const mine = magic + static_cast<int>(role);
  std::vector<int> answers(size);
  MPI_Request request;
  PMPI_Iallgather(&mine, 1, MPI_INT, answers.data(), 1, MPI_INT, MPI_COMM_WORLD, &request);
  double const patience = waiter.patience();
  waiter.patience(join_deadline_s);
  waiter.joining(true);
  waiter.request(request, [role] {
    return fmt::format("every process to join (was slidewave_{} started?)",
                       role == Role::fluid ? "dem" : "foam");
  });
  waiter.patience(patience);
  waiter.joining(false);
  return answers;
}

int first_of(std::vector<int> const& roles, Role role) {
  for (std::size_t r = 0; r < roles.size(); ++r) {
    if (roles[r] == magic + static_cast<int>(role)) {
      return static_cast<int>(r);
    }
  }
  return -1;
}

int count_of(std::vector<int> const& roles, Role role) {
  int count = 0;
  for (int answer : roles) {
    count += answer == magic + static_cast<int>(role);
  }
  return count;
}

}  // namespace

char const* name_of(Role role) {
  return role == Role::fluid ? "fluid" : "dem";
}

bool start_mpi(Role role) {
  int initialised = 0;
  MPI_Initialized(&initialised);
  if (initialised) {
    return false;
  }
  StartGuard guard(role);
  int provided = 0;
  PMPI_Init_thread(nullptr, nullptr, MPI_THREAD_SINGLE, &provided);
  return true;
}

World World::join(Role role, bool partner_expected, Waiter& waiter, Failure const& failure) {
  std::vector<int> const roles = gather_roles(role, waiter);
  int const own = count_of(roles, role);
  int const partners = count_of(roles, other(role));
  if (own + partners != static_cast<int>(roles.size())) {
    failure.fail(fmt::format("{} of {} processes are not part of slidewave (or of another version)",
                             roles.size() - own - partners, roles.size()),
                 2);
  }
  if (partner_expected != (partners > 0)) {
    failure.fail(
        fmt::format("{} x {}, {} x {} were started: {}", own, name_of(role), partners,
                    name_of(other(role)),
                    partner_expected
                        ? fmt::format("role '{}' is missing; start slidewave_{} in the same mpirun",
                                      name_of(other(role)), role == Role::fluid ? "dem" : "foam")
                        : fmt::format("the case sets {}.engine = \"none\" and wants no {} process",
                                      name_of(other(role)), name_of(other(role)))),
        2);
  }
  World world;
  PMPI_Comm_dup(MPI_COMM_WORLD, &world.all);
  int world_rank = 0;
  PMPI_Comm_rank(world.all, &world_rank);
  PMPI_Comm_split(world.all, static_cast<int>(role), world_rank, &world.side);
  PMPI_Comm_dup(world.side, &world.engine);
  PMPI_Comm_rank(world.side, &world.rank);
  PMPI_Comm_size(world.side, &world.size);
  if (partners > 0) {
    PMPI_Intercomm_create(world.side, 0, world.all, first_of(roles, other(role)), 1, &world.inter);
    PMPI_Comm_remote_size(world.inter, &world.partner_size);
  }
  return world;
}

void World::free() {
  for (MPI_Comm* comm : {&inter, &engine, &side, &all}) {
    if (*comm != MPI_COMM_NULL) {
      PMPI_Comm_free(comm);
    }
  }
}

}  // namespace slidewave
