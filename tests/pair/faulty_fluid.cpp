// The fake fluid engine with the faults of fault_matrix.py.
#define main fake_fluid_main
#include "fake_fluid.cpp"
#undef main
#include "matrix_fault.hpp"

struct FaultyFluid : FakeFluid {
  using FakeFluid::FakeFluid;
  MatrixFault fault_here{session, "fluid"};
  std::vector<Quantity> columns = FakeFluid::quantities();
  long next = 0;  // the window whose exchange comes
  bool lost = false;

  void meet(char const* place) {
    fault_here.strike(place, next);
    if (fault_here.is("nan_force", place, next)) grad_p.setConstant(NAN);
    if (fault_here.is("nan_field", place, next)) u.setConstant(NAN);
    if (fault_here.is("layout", place, next)) columns.push_back({"one_too_many", 0});
    lost = lost || fault_here.is("lost", place, next);
  }
  Home locate(Vec3 const& x_m, int hint) override {  // particles come in
    meet("in");
    return lost ? Home() : FakeFluid::locate(x_m, hint);
  }
  void deposit(Table::ConstColumn particle_volume) override {
    meet("after");
    FakeFluid::deposit(particle_volume);
  }
  void advance(Window const& window) override {
    FakeFluid::advance(window);
    next = window.index + 1;
  }
  Vec3 given_impulse() const override {  // the window is over, its answers are sent
    const_cast<FaultyFluid*>(this)->meet("before");
    return FakeFluid::given_impulse();
  }
  std::vector<Quantity> quantities() const override { return columns; }
};

int main(int, char** arguments) {
  Session session(Role::fluid, arguments[1]);
  return guarded(session, [](Session& s) {
    FaultyFluid engine{s};
    s.state("boundary", "pbb");
    return run(s, engine);
  });
}
