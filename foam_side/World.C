#include <unistd.h>

#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "PstreamGlobals.H"
#include "UPstream.H"
#include "World.H"
#include "error.H"

namespace slidewave::foam {
namespace {

struct World {
  MPI_Comm comm = MPI_COMM_NULL;
  FailureRoute fail;
};

World& world() {
  static World instance;
  return instance;
}

// OpenFOAM's libraries read their data folder while they are loaded, before main(). Where the user
// names none, the program starts itself again with Debian's, before any library has run.
void nameDataFolder(int, char** argv, char** environment) {
  constexpr char folder[] = "WM_PROJECT_DIR=/usr/share/openfoam";
  constexpr std::size_t name_length = sizeof("WM_PROJECT_DIR=") - 1;
  static char const* longer[8192];
  std::size_t count = 0;
  for (; environment[count]; ++count) {
    if (std::strncmp(environment[count], folder, name_length) == 0 || count > 8000) return;
    longer[count] = environment[count];
  }
  longer[count] = folder;
  static char path[4096];  // the true path, so that process lists show the program's name
  if (readlink("/proc/self/exe", path, sizeof(path) - 1) > 0) {
    execve(path, argv, const_cast<char**>(longer));
  }
}

[[gnu::section(".preinit_array"),
  gnu::used]] void (*const beforeLibraries)(int, char**, char**) = nameDataFolder;

void onFloatingPointError(int) {
  std::signal(SIGFPE, SIG_DFL);
  failWorld("fluid: floating-point exception (division by zero or NaN); see log.fluid");
}

}  // namespace

void enterWorld(MPI_Comm comm, FailureRoute fail) {
  world() = {comm, std::move(fail)};
  setenv("FOAM_SIGFPE", "false", /*overwrite=*/1);  // ours, below
  std::signal(SIGFPE, onFloatingPointError);
  Foam::FatalError.throwExceptions();
  Foam::FatalIOError.throwExceptions();
}

void failWorld(std::string const& reason, int status) {
  if (world().fail) {
    world().fail(reason, status);
  }
  MPI_Abort(MPI_COMM_WORLD, status);
  std::abort();
}

TrapFloatingPoint::TrapFloatingPoint() : before_(fegetexcept()) {
  std::feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
}

TrapFloatingPoint::~TrapFloatingPoint() {
  std::feclearexcept(FE_ALL_EXCEPT);
  fedisableexcept(FE_ALL_EXCEPT);
  feenableexcept(before_);
}

}  // namespace slidewave::foam

// The four members that OpenFOAM 1912's libPstream defines on MPI_COMM_WORLD.

bool Foam::UPstream::init(int&, char**&, bool const needsThread) {
  MPI_Comm const comm = slidewave::foam::world().comm;
  int size = 0;
  MPI_Comm_size(comm, &size);
  setParRun(size, needsThread);

  // OpenFOAM's buffered sends need an attached buffer; it stays until the process ends.
  static std::vector<char> buffer(std::max(UPstream::mpiBufferSize, 20000000));
  MPI_Buffer_attach(buffer.data(), static_cast<int>(buffer.size()));
  return true;
}

void Foam::UPstream::exit(int status) {
  if (status != 0) {
    slidewave::foam::failWorld("OpenFOAM left with status " + std::to_string(status), status);
  }
  // A regular end (argList's destructor): MPI belongs to the session, which finalises it.
}

void Foam::UPstream::abort() {
  slidewave::foam::failWorld("OpenFOAM aborted");
}

void Foam::UPstream::allocatePstreamCommunicator(const label parent, const label index) {
  using namespace PstreamGlobals;
  if (index == MPIGroups_.size()) {
    MPI_Group noGroup = MPI_GROUP_NULL;
    MPI_Comm noComm = MPI_COMM_NULL;
    MPIGroups_.append(noGroup);
    MPICommunicators_.append(noComm);
  }
  if (parent == -1) {
    MPICommunicators_[index] = slidewave::foam::world().comm;
    MPI_Comm_group(MPICommunicators_[index], &MPIGroups_[index]);
    int size = 0;
    MPI_Comm_size(MPICommunicators_[index], &size);
    procIDs_[index] = identity(size);
  } else {
    MPI_Group_incl(MPIGroups_[parent], procIDs_[index].size(), procIDs_[index].cdata(),
                   &MPIGroups_[index]);
    MPI_Comm_create(MPICommunicators_[parent], MPIGroups_[index], &MPICommunicators_[index]);
  }
  myProcNo_[index] = -1;
  if (MPICommunicators_[index] != MPI_COMM_NULL) {
    MPI_Comm_rank(MPICommunicators_[index], &myProcNo_[index]);
  }
}
