// foam_drive DIR: the fluid engine alone, with particles that move on straight lines.
//
// DIR/case.toml and DIR/fluid as in a coupled run; DIR/particles.csv (may be absent) has a row a
// particle: x,y,z,vx,vy,vz,volume,K,fx,fy,fz; with models.virtual_mass a particle moves along half
// its volume of water. Writes DIR/samples.csv (a row a window and particle)
// and DIR/windows.csv (a row a window: quantities and budgets).
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "FoamEngine.H"
#include "World.H"
#include "error.H"

namespace {

using namespace slidewave;
using Eigen::MatrixXd;

struct Comm {
  MPI_Comm comm;
  int rank;
  void sum(MatrixXd& m) const {
    MPI_Allreduce(MPI_IN_PLACE, m.data(), static_cast<int>(m.size()), MPI_DOUBLE, MPI_SUM, comm);
  }
};

MatrixXd readParticles(std::filesystem::path const& file) {
  std::ifstream stream(file);
  std::vector<double> values;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
  }
  return Eigen::Map<MatrixXd>(values.data(), 11, static_cast<long>(values.size()) / 11);
}

// Particles of this rank and their cells: the rank that is nearest, ties to the lowest.
// `hints` are the cells of the last call.
std::vector<int> own(foam::FoamEngine& engine, Comm const& world, MatrixXd const& all,
                     std::vector<int>& hints, std::vector<int>& cells, double& farthest) {
  std::vector<int> mine;
  cells.clear();
  for (long i = 0; i < all.cols(); ++i) {
    Home const home = engine.locate(all.block<3, 1>(0, i), hints[i]);
    hints[i] = home.cell;
    struct {
      double distance;
      int rank;
    } best{home.cell < 0 ? 1e300 : home.distance_m, world.rank};
    MPI_Allreduce(MPI_IN_PLACE, &best, 1, MPI_DOUBLE_INT, MPI_MINLOC, world.comm);
    farthest = std::max(farthest, best.distance);
    if (best.rank != world.rank) continue;
    mine.push_back(static_cast<int>(i));
  }
  std::stable_sort(mine.begin(), mine.end(), [&](int a, int b) { return hints[a] < hints[b]; });
  for (int const i : mine) cells.push_back(hints[i]);
  return mine;
}

int drive(std::filesystem::path const& directory) {
  Comm world{MPI_COMM_WORLD, 0};
  MPI_Comm_rank(world.comm, &world.rank);
  Scene const scene(directory);
  foam::FoamEngine engine(scene, world.comm);
  bool const two_way = scene.text("coupling.reaction", "two_way") == "two_way";
  bool const stiff = two_way && scene.text("coupling.regime", "mild") == "stiff";
  bool const shares_pressure = scene.text("models.formulation", "A") == "A";
  bool const shares_stress = scene.flag("models.viscous_force", false);
  bool const moves_along = scene.text("models.virtual_mass", "none") != "none";
  double const window_s = scene.number("coupling.window");
  long const windows = std::lround(scene.number("case.end_time") / window_s);

  MatrixXd all = readParticles(directory / "particles.csv");
  std::FILE* samples = nullptr;
  std::FILE* rows = nullptr;
  if (world.rank == 0) {
    samples = std::fopen((directory / "samples.csv").c_str(), "w");
    rows = std::fopen((directory / "windows.csv").c_str(), "w");
  }
  std::string header = "window,particle,x,y,z";
  std::vector<Field> const fields = engine.samples();
  int components = 0;
  for (Field const& field : fields) {
    components += field.components;
    for (int k = 0; k < field.components; ++k) {
      header += ',' + field.name + (field.components > 1 ? std::string(1, "xyz"[k]) : "");
    }
  }
  if (samples) std::fprintf(samples, "%s\n", header.c_str());

  std::vector<int> hints(all.cols(), -1);
  for (long index = 0; index <= windows; ++index) {
    Window const window{index, std::max(0l, index - 1) * window_s, index * window_s, false, false};
    std::vector<int> cells;
    double farthest = 0;
    std::vector<int> const mine = own(engine, world, all, hints, cells, farthest);
    MatrixXd const here = all(Eigen::all, mine);
    auto const column = [](MatrixXd const& m) {
      return Table::ConstColumn(m.data(), m.rows(), m.cols());
    };
    MatrixXd const x = here.topRows(3), v = here.middleRows(3, 3), volume = here.row(6),
                   drag = here.row(7), force = here.bottomRows(3), added = 500 * volume;
    engine.place(column(x), cells);
    if (two_way) {
      engine.deposit(column(volume));
      if (moves_along) engine.add_mass(column(added));
      if (index % 2 == 0) {
        engine.exchange(column(drag), column(v), column(force));
      } else {  // as a coupled run does: the columns are filled from what was sampled, here not
        MatrixXd u(3, here.cols());
        std::string const name = "velocity";
        long rows_done = 0;
        engine.sample_and_exchange(
            {{name, Table::Column(u.data(), u.rows(), u.cols())}},
            [&](long, long count) { rows_done += count; }, column(drag), column(v), column(force));
        if (rows_done != here.cols()) throw std::runtime_error("rows were left out");
      }
    }
    engine.advance(window);

    MatrixXd out = MatrixXd::Zero(components, all.cols());
    int row = 0;
    MatrixXd mean_velocity = MatrixXd::Zero(3, here.cols());
    MatrixXd gradient = mean_velocity, acceleration = mean_velocity;
    for (Field const& field : fields) {
      MatrixXd values = MatrixXd::Zero(field.components, here.cols());
      bool const kept = field.name == "drag_reaction"       ? stiff
                        : field.name == "mean_velocity"     ? two_way
                        : field.name == "acceleration"      ? moves_along
                        : field.name == "pressure_gradient" ? shares_pressure
                        : field.name == "viscous_stress"    ? shares_stress
                                                            : true;
      if (kept) {
        engine.sample(field.name, Table::Column(values.data(), values.rows(), values.cols()));
      }
      if (field.name == "mean_velocity") mean_velocity = values;
      if (field.name == "pressure_gradient") gradient = values;
      if (field.name == "acceleration") acceleration = values;
      for (std::size_t i = 0; i < mine.size(); ++i) {
        out.block(row, mine[i], field.components, 1) = values.col(static_cast<long>(i));
      }
      row += field.components;
    }
    world.sum(out);
    // What the particles say they took, and what the cells say they gave; likewise for pressure.
    MatrixXd sums(3, 5);
    sums.setZero();
    MatrixXd const slip = mean_velocity - v;
    sums.col(0) = window.length_s() * (slip * drag.row(0).asDiagonal() - force +
                                       acceleration * added.row(0).asDiagonal())
                                          .rowwise()
                                          .sum();
    sums.col(1) = engine.given_impulse();
    sums.col(2) = (gradient * volume.row(0).asDiagonal()).rowwise().sum();
    sums.col(3) = engine.solid_pressure_force();
    sums(0, 4) = volume.sum();
    sums(1, 4) = engine.solid_volume_m3();
    world.sum(sums);

    if (world.rank == 0) {
      for (long i = 0; i < all.cols(); ++i) {
        std::fprintf(samples, "%ld,%ld", index, i);
        for (int k = 0; k < 3; ++k) std::fprintf(samples, ",%.17g", all(k, i));
        for (long k = 0; k < out.rows(); ++k) std::fprintf(samples, ",%.17g", out(k, i));
        std::fprintf(samples, "\n");
      }
      auto const quantities = engine.quantities();
      if (index == 0) {
        std::fprintf(rows, "window,farthest");
        for (char const* name :
             {"particle_impulse", "given", "particle_pressure", "cell_pressure"}) {
          for (char const axis : {'x', 'y', 'z'}) std::fprintf(rows, ",%s_%c", name, axis);
        }
        std::fprintf(rows, ",particle_volume,solid_volume,unused");
        for (auto const& quantity : quantities) std::fprintf(rows, ",%s", quantity.name.c_str());
        std::fprintf(rows, "\n");
      }
      std::fprintf(rows, "%ld,%.17g", index, farthest);
      for (long k = 0; k < sums.size(); ++k) std::fprintf(rows, ",%.17g", sums.data()[k]);
      for (auto const& quantity : quantities) std::fprintf(rows, ",%.17g", quantity.value);
      std::fprintf(rows, "\n");
      std::fflush(rows);
    }
    if (index > 0) all.topRows(3) += window_s * all.middleRows(3, 3);
  }
  if (world.rank == 0) {
    std::fclose(samples);
    std::fclose(rows);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  slidewave::foam::enterWorld(MPI_COMM_WORLD, [](std::string const& reason, int status) {
    std::cerr << "foam_drive: " << reason << std::endl;
    MPI_Abort(MPI_COMM_WORLD, status);
  });
  try {
    int const status = drive(argc > 1 ? argv[1] : ".");
    MPI_Finalize();
    return status;
  } catch (Foam::error const& problem) {
    slidewave::foam::failWorld(problem.message());
  } catch (std::exception const& problem) {
    slidewave::foam::failWorld(problem.what());
  }
}
