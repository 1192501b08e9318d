// What a session holds. Only sources of the library see it.
#pragma once

#include "agreement.hpp"
#include "facts.hpp"
#include "models.hpp"
#include "slidewave/coupler.hpp"

namespace slidewave {

struct Session::Impl {
  Impl(Role as, std::filesystem::path const& directory);
  ~Impl();

  Role role;
  double start_s;
  Failure failure;
  Profile profile;
  Waiter waiter;
  bool finalises_mpi;
  Scene scene;
  World world;
  Agreement agreement;
  std::vector<Fact> facts;
  bool left = false;

  bool is_root() const { return world.rank == 0; }
  void say(std::string const& line) const;
};

}  // namespace slidewave
