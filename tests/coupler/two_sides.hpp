// Both roles in one test program: even ranks are fluid, odd ones dem; one rank alone is a dry dem.
#pragma once

#include "scratch.hpp"
#include "session_impl.hpp"

struct TwoSides {
  static int world_size() {
    int size = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
  }
  static int world_rank() {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
  }
  static slidewave::Role role() {
    bool const fluid = world_size() > 1 && world_rank() % 2 == 0;
    return fluid ? slidewave::Role::fluid : slidewave::Role::dem;
  }
  static std::string text() {
    return world_size() == 1 ? "[fluid]\nengine = \"none\"\n" : "[coupling]\npatience = 20\n";
  }

  Scratch scratch{text()};
  slidewave::Session::Impl session{role(), scratch.path};
  bool is_fluid() const { return session.role == slidewave::Role::fluid; }
  ~TwoSides() {
    MPI_Barrier(MPI_COMM_WORLD);
    session.left = true;
  }
};
