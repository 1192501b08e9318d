// The fake particles in a process that counts the coupler's allocations.
#include "count_allocations.hpp"
#define main fake_dem_main
#include "fake_dem.cpp"
#undef main

struct CountedDem : FakeDem {
  using FakeDem::FakeDem;
  void gather(Table& particles) override {
    counted::Pause const pause;
    FakeDem::gather(particles);
  }
  void apply(Table const& answers) override {
    counted::Pause const pause;
    FakeDem::apply(answers);
  }
  void advance(Window const& window) override {
    counted::Pause const pause;
    FakeDem::advance(window);
    counted::window_begins(session, "dem", window.index);
  }
};

int main(int, char** arguments) {
  Session session(Role::dem, arguments[1]);
  return guarded(session, [](Session& s) {
    CountedDem engine(s);
    s.state("gravity", "0 0 -9.81");
    s.state("boundary", "pbb");
    return run(s, engine);
  });
}
