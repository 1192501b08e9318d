// The fake particle engine with the faults of fault_matrix.py.
#define main fake_dem_main
#include "fake_dem.cpp"
#undef main
#include "matrix_fault.hpp"

struct FaultyDem : FakeDem {
  using FakeDem::FakeDem;
  MatrixFault fault_here{session, "dem"};
  std::vector<Quantity> columns;
  long next = 0;  // the window whose exchange comes

  void meet(char const* place) {
    fault_here.strike(place, next);
    if (fault_here.is("nan_force", place, next)) v.col(0).setConstant(NAN);
    if (fault_here.is("nan_field", place, next)) x.col(0).setConstant(NAN);
    if (fault_here.is("lost", place, next)) x(2, 0) = -5;
    if (fault_here.is("layout", place, next)) columns.push_back({"one_too_many", 0});
  }
  void advance(Window const& window) override {
    FakeDem::advance(window);
    next = window.index + 1;
    meet("before");
  }
  void gather(Table& particles) override {
    meet("in");
    FakeDem::gather(particles);
  }
  void apply(Table const& answers) override {
    FakeDem::apply(answers);
    meet("after");
  }
  std::vector<Quantity> quantities() const override { return columns; }
};

int main(int, char** arguments) {
  Session session(Role::dem, arguments[1]);
  return guarded(session, [](Session& s) {
    FaultyDem engine(s);
    return run(s, engine);
  });
}
