// The fake fluid in a process that counts the coupler's allocations.
#include "count_allocations.hpp"
#define main fake_fluid_main
#include "fake_fluid.cpp"
#undef main

struct CountedFluid : FakeFluid {
  using FakeFluid::FakeFluid;
  Home locate(Vec3 const& x, int hint) override {
    counted::Pause const pause;
    return FakeFluid::locate(x, hint);
  }
  void place(Table::ConstColumn x, std::vector<int> const& owner) override {
    counted::Pause const pause;
    FakeFluid::place(x, owner);
  }
  void deposit(Table::ConstColumn particle_volume) override {
    counted::Pause const pause;
    FakeFluid::deposit(particle_volume);
  }
  void exchange(Table::ConstColumn K, Table::ConstColumn v, Table::ConstColumn force) override {
    counted::Pause const pause;
    FakeFluid::exchange(K, v, force);
  }
  void advance(Window const& window) override {
    counted::Pause const pause;
    FakeFluid::advance(window);
    counted::window_begins(session, "fluid", window.index);
  }
  void sample(std::string const& field, Table::Column out) override {
    counted::Pause const pause;
    FakeFluid::sample(field, out);
  }
  Vec3 solid_pressure_force() const override {
    counted::Pause const pause;
    return FakeFluid::solid_pressure_force();
  }
  std::vector<Quantity> quantities() const override {
    counted::Pause const pause;
    return FakeFluid::quantities();
  }
};

int main(int, char** arguments) {
  Session session(Role::fluid, arguments[1]);
  return guarded(session, [](Session& s) {
    CountedFluid engine{s};
    s.state("gravity", "0 0 -9.81");
    s.state("boundary", "pbb");
    return run(s, engine);
  });
}
