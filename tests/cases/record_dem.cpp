// slidewave_dem that also records what crosses the coupling: record_dem DIR appends to
// DIR/answers_<rank>.bin, for each window and particle, 12 doubles: window, radius, position (3),
// K, u_f (3), F (3), as in docs/protocol.md; F is all that acts beside drag, lift among it.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "liggghts_engine.h"
#include "slidewave/coupler.hpp"

namespace {

using slidewave::Table;

class Recorder final : public slidewave::dem::LiggghtsEngine {
 public:
  Recorder(slidewave::Session& session, std::filesystem::path const& file)
      : LiggghtsEngine(session), out_(file, std::ios::binary) {}

  void gather(Table& particles) override {
    LiggghtsEngine::gather(particles);
    sent_ = &particles;
  }

  void apply(Table const& answers) override {
    for (long i = 0; i < answers.size(); ++i) {
      put(Scalar(static_cast<double>(window_)));
      put(column<1>(*sent_, "radius", i));
      put(column<3>(*sent_, "position", i));
      put(column<1>(answers, "drag", i));
      put(column<3>(answers, "fluid_velocity", i));
      put(column<3>(answers, "force", i) + column<3>(answers, "exchanged_force", i));
    }
    ++window_;
    LiggghtsEngine::apply(answers);
  }

 private:
  using Scalar = Eigen::Vector<double, 1>;

  /// A particle's values; zero where no model of the scene fills the column.
  template <int components>
  static Eigen::Vector<double, components> column(Table const& table, char const* name, long row) {
    if (!table.has(name)) {
      return Eigen::Vector<double, components>::Zero();
    }
    return table[name].col(row);
  }

  template <typename Values>
  void put(Eigen::MatrixBase<Values> const& values) {
    for (double const value : values.eval()) {
      out_.write(reinterpret_cast<char const*>(&value), sizeof(value));
    }
  }

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
