// The fake fluid with air in the middle third of the row: what a free surface changes for the
// ledger.
#define main fake_fluid_main
#include "fake_fluid.cpp"
#undef main

struct FakeAir : FakeFluid {
  using FakeFluid::FakeFluid;
  std::vector<Field> samples() const override {
    std::vector<Field> fields = FakeFluid::samples();
    fields.push_back({"saturation", "-", 1});
    return fields;
  }
  void sample(std::string const& field, Table::Column out) override {
    FakeFluid::sample(field, out);
    for (long i = 0; i < out.cols() && field == "saturation"; ++i) {
      out(0, i) = 3 * cell[i] / cells == 1 ? 0 : 1;
    }
  }
  /// Air takes no repayment: a force that were given to one of its cells would show here.
  void exchange(Table::ConstColumn K, Table::ConstColumn v, Table::ConstColumn force) override {
    for (long i = 0; i < force.cols(); ++i) {
      if (3 * cell[i] / cells == 1 && force.col(i).norm() > 0) {
        throw std::runtime_error("a ledger was repaid to air");
      }
    }
    FakeFluid::exchange(K, v, force);
  }
};

int main(int, char** arguments) {
  Session session(Role::fluid, arguments[1]);
  return guarded(session, [](Session& s) {
    FakeAir engine(s);
    return run(s, engine);
  });
}
