#include "world.h"

#include <mpi.h>

namespace slidewave::esys {
namespace {

struct World {
  MPI_Comm comm = MPI_COMM_WORLD;
  Session const* session = nullptr;
  std::function<void()> leave;
};

World& world() {
  static World instance;
  return instance;
}

MPI_Comm seen(MPI_Comm comm) {
  return comm == MPI_COMM_WORLD ? world().comm : comm;
}

constexpr int tag_announced = 4711;
enum Announced { broadcast = 1, leave = 2 };

void announce(int what) {
  World const& w = world();
  for (int rank = 1; rank < w.session->size(); ++rank) {
    PMPI_Send(&what, 1, MPI_INT, rank, tag_announced, w.comm);
  }
}

/// Master and workers before a broadcast over the whole world.
void before_broadcast() {
  World const& w = world();
  if (w.session->rank() == 0) {
    announce(broadcast);
    return;
  }
  for (int what = leave; what != broadcast;) {
    PMPI_Recv(&what, 1, MPI_INT, 0, tag_announced, w.comm, MPI_STATUS_IGNORE);
    if (what == leave) {
      w.leave();
    }
  }
}

}  // namespace

void enter_world(Session const& session) {
  world().comm = session.comm();
  world().session = &session;
}

void on_leave(std::function<void()> leave) {
  world().leave = std::move(leave);
}

void let_workers_leave() {
  announce(leave);
}

}  // namespace slidewave::esys

using slidewave::esys::seen;

extern "C" {

int MPI_Abort(MPI_Comm, int code) {
  if (slidewave::esys::world().session) {
    slidewave::esys::world().session->fail("ESyS-Particle ended itself (see log.dem)");
  }
  return PMPI_Abort(MPI_COMM_WORLD, code);
}

int MPI_Bcast(void* data, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  if (comm == MPI_COMM_WORLD && slidewave::esys::world().session) {
    slidewave::esys::before_broadcast();
  }
  return PMPI_Bcast(data, count, type, root, seen(comm));
}

int MPI_Comm_rank(MPI_Comm comm, int* rank) {
  return PMPI_Comm_rank(seen(comm), rank);
}
int MPI_Comm_size(MPI_Comm comm, int* size) {
  return PMPI_Comm_size(seen(comm), size);
}
int MPI_Comm_group(MPI_Comm comm, MPI_Group* group) {
  return PMPI_Comm_group(seen(comm), group);
}
int MPI_Comm_create(MPI_Comm comm, MPI_Group group, MPI_Comm* made) {
  return PMPI_Comm_create(seen(comm), group, made);
}
int MPI_Comm_dup(MPI_Comm comm, MPI_Comm* made) {
  return PMPI_Comm_dup(seen(comm), made);
}
int MPI_Barrier(MPI_Comm comm) {
  return PMPI_Barrier(seen(comm));
}
int MPI_Send(void const* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  return PMPI_Send(data, count, type, to, tag, seen(comm));
}
int MPI_Recv(void* data, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm,
             MPI_Status* status) {
  return PMPI_Recv(data, count, type, from, tag, seen(comm), status);
}
int MPI_Isend(void const* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request* request) {
  return PMPI_Isend(data, count, type, to, tag, seen(comm), request);
}
int MPI_Irecv(void* data, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm,
              MPI_Request* request) {
  return PMPI_Irecv(data, count, type, from, tag, seen(comm), request);
}
int MPI_Probe(int from, int tag, MPI_Comm comm, MPI_Status* status) {
  return PMPI_Probe(from, tag, seen(comm), status);
}
int MPI_Pack(void const* in, int count, MPI_Datatype type, void* out, int size, int* position,
             MPI_Comm comm) {
  return PMPI_Pack(in, count, type, out, size, position, seen(comm));
}
int MPI_Unpack(void const* in, int size, int* position, void* out, int count, MPI_Datatype type,
               MPI_Comm comm) {
  return PMPI_Unpack(in, size, position, out, count, type, seen(comm));
}
int MPI_Pack_size(int count, MPI_Datatype type, MPI_Comm comm, int* size) {
  return PMPI_Pack_size(count, type, seen(comm), size);
}
int MPI_Gather(void const* in, int count, MPI_Datatype type, void* out, int out_count,
               MPI_Datatype out_type, int root, MPI_Comm comm) {
  return PMPI_Gather(in, count, type, out, out_count, out_type, root, seen(comm));
}
int MPI_Gatherv(void const* in, int count, MPI_Datatype type, void* out, int const* counts,
                int const* starts, MPI_Datatype out_type, int root, MPI_Comm comm) {
  return PMPI_Gatherv(in, count, type, out, counts, starts, out_type, root, seen(comm));
}
int MPI_Scatter(void const* in, int count, MPI_Datatype type, void* out, int out_count,
                MPI_Datatype out_type, int root, MPI_Comm comm) {
  return PMPI_Scatter(in, count, type, out, out_count, out_type, root, seen(comm));
}
int MPI_Scatterv(void const* in, int const* counts, int const* starts, MPI_Datatype type, void* out,
                 int out_count, MPI_Datatype out_type, int root, MPI_Comm comm) {
  return PMPI_Scatterv(in, counts, starts, type, out, out_count, out_type, root, seen(comm));
}
int MPI_Reduce(void const* in, void* out, int count, MPI_Datatype type, MPI_Op op, int root,
               MPI_Comm comm) {
  return PMPI_Reduce(in, out, count, type, op, root, seen(comm));
}
int MPI_Allreduce(void const* in, void* out, int count, MPI_Datatype type, MPI_Op op,
                  MPI_Comm comm) {
  return PMPI_Allreduce(in, out, count, type, op, seen(comm));
}
}
