// slidewave_dem that also records what crosses the coupling: record_dem DIR appends to
// DIR/answers_<rank>.bin, for each window and particle, 12 doubles: window, radius, position (3),
// K, u_f (3), F (3), as in docs/protocol.md.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "liggghts_engine.h"
#include "slidewave/coupler.hpp"

namespace {

using slidewave::Table;

class Recorder final : public slidewave::ParticleEngine {
 public:
  Recorder(slidewave::Session& session, std::filesystem::path const& file)
      : engine_(session), out_(file, std::ios::binary) {}

  slidewave::Box bounds() const override { return engine_.bounds(); }
  std::vector<slidewave::Quantity> quantities() const override { return engine_.quantities(); }
  std::vector<slidewave::Feature> features() const override { return engine_.features(); }
  std::optional<slidewave::Vec3> received_impulse() const override {
    return engine_.received_impulse();
  }

  void gather(Table& particles) override {
    engine_.gather(particles);
    sent_ = &particles;
  }

  void apply(Table const& answers) override {
    for (long i = 0; i < answers.size(); ++i) {
      put(static_cast<double>(window_));
      put_column(*sent_, "radius", i);
      put_column(*sent_, "position", i);
      for (char const* name : {"drag", "fluid_velocity", "force"}) {
        put_column(answers, name, i);
      }
    }
    ++window_;
    engine_.apply(answers);
  }

  void advance(slidewave::Window const& window) override { engine_.advance(window); }

 private:
  void put(double value) { out_.write(reinterpret_cast<char const*>(&value), sizeof(value)); }

  void put_column(Table const& table, char const* name, long row) {
    Table::ConstColumn const column = table[name];
    for (long k = 0; k < column.rows(); ++k) {
      put(column(k, row));
    }
  }

  slidewave::dem::LiggghtsEngine engine_;
  std::ofstream out_;
  Table const* sent_ = nullptr;
  long window_ = 0;
};

int couple(slidewave::Session& session) {
  Recorder recorder(session, session.scene().directory() /
                                 ("answers_" + std::to_string(session.rank()) + ".bin"));
  return slidewave::run(session, recorder);
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::fprintf(stderr, "usage: record_dem DIR\n");
    return 2;
  }
  slidewave::Session session(slidewave::Role::dem, std::filesystem::absolute(arguments[1]));
  return slidewave::guarded(session, couple);
}
