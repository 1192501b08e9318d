// What is reported of particles on one and two ranks against brute force: front, energy, pictures
// with layers, and the list of pictures through a checkpoint.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "scratch.hpp"
#include "slidewave/particle_report.hpp"

using namespace slidewave;

namespace {

/// The dry session of all tests here.
struct Joined : ::testing::Environment {
  static Joined*& current() {
    static Joined* joined = nullptr;
    return joined;
  }
  std::unique_ptr<Scratch> scratch;
  std::unique_ptr<Session> session;
  void SetUp() override {
    int ranks = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    scratch = std::make_unique<Scratch>(
        "[fluid]\nengine = \"none\"\n[output]\ninterval = 0.5\nlayers = 3\n"
        "[observe.slide]\ntype = \"slide\"\n[observe.fifth]\ntype = \"particle\"\nid = 5\n",
        "particle_report_np" + std::to_string(ranks));
    std::filesystem::create_directories(scratch->path / "dem");
    MPI_Barrier(MPI_COMM_WORLD);
    session = std::make_unique<Session>(Role::dem, scratch->path);
    current() = this;
  }
  void TearDown() override {
    session->leave();
    session.reset();
  }
};
auto* const joined = ::testing::AddGlobalTestEnvironment(new Joined);

Session& session() {
  return *Joined::current()->session;
}

/// Particles 1 to `count`, dealt out to the ranks in turn; the n-th is what `place(n)` says.
template <class Place>
Table particles(int count, Place const& place) {
  Table table;
  ParticleReport::add_columns(table);
  for (int n = session().rank(); n < count; n += session().size()) {
    long const row = table.size();
    table.resize(row + 1);
    table["id"](0, row) = n + 1;
    table["radius"](0, row) = 0.1;
    table["mass"](0, row) = 2;
    table["position"].col(row) = Vec3(place(n));
    table["velocity"].col(row) = Vec3(1, 2, -2);
    table["angular_velocity"].col(row) = Vec3(0, 5, 0);
  }
  return table;
}

double value_of(std::vector<Quantity> const& columns, std::string const& name) {
  for (Quantity const& one : columns) {
    if (one.name == name) {
      return one.value;
    }
  }
  ADD_FAILURE() << "no column " << name;
  return 0;
}

TEST(ParticleReport, FrontHoldsTheGivenPartOfTheMass) {
  Table const table = particles(200, [](int n) { return Vec3(0.5 + 0.045 * n, 5, 5); });
  for (auto const& [part, last] : {std::pair(0.99, 197), {0.50, 99}, {1.00, 199}}) {
    EXPECT_NEAR(mass_front_x(table, part, session().comm()), 0.5 + 0.045 * last, 2e-5);
  }
  Table const one = particles(1, [](int) { return Vec3(3, 0, 0); });
  EXPECT_EQ(mass_front_x(one, 0.99, session().comm()), 3);
  Table const none = particles(0, [](int) { return Vec3(0, 0, 0); });
  EXPECT_EQ(mass_front_x(none, 0.99, session().comm()), 0);
}

TEST(ParticleReport, ColumnsAreSumsOverAllRanks) {
  ParticleReport report(session());
  Table const table = particles(9, [](int n) { return Vec3(n, 0, -n); });
  auto const columns = report.observe(table, session().rank() == 0 ? 0.01 : 0.02);
  EXPECT_NEAR(value_of(columns, "slide_speed_m_s"), 3, 1e-12);
  double const spin = 0.4 * 0.1 * 0.1 * 25;
  EXPECT_NEAR(value_of(columns, "kinetic_energy_J"), 9 * 0.5 * 2 * (9 + spin), 1e-12);
  EXPECT_EQ(value_of(columns, "max_overlap"), session().size() == 1 ? 0.01 : 0.02);
  EXPECT_EQ(value_of(columns, "fifth_z_m"), -4);
  EXPECT_EQ(value_of(columns, "fifth_vy_m_s"), 2);
}

TEST(ParticleReport, UnknownParticleIsRefused) {
  ParticleReport report(session());
  EXPECT_THROW(report.observe(particles(3, [](int) { return Vec3(0, 0, 0); }), 0), InputError);
}

std::string content(std::string const& name) {
  MPI_Barrier(session().comm());
  std::ifstream file(session().scene().directory() / "dem" / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

template <class T>
T big_endian(char const* from) {
  char bytes[sizeof(T)];
  std::reverse_copy(from, from + sizeof(T), bytes);
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

TEST(ParticleReport, PicturesHoldEveryParticleSortedByIdWithItsLayer) {
  int const count = 9;
  auto const start = [](int n) { return Vec3(9.5 - n, 5, 1 + 0.5 * n); };
  ParticleReport report(session());
  report.picture(particles(count, start), 0, 0);
  report.picture(particles(count, start), 10, 0.2);  // not due
  auto const moved = [&](int n) { return Vec3(start(n) + Vec3(0, 0, 5 - n)); };
  report.picture(particles(count, moved), 25, 0.5);
  EXPECT_TRUE(content("particles_10.vtk").empty());
  std::string const vtk = content("particles_25.vtk");
  auto const after = [&](std::string const& header) {
    std::size_t const at = vtk.find(header);
    EXPECT_NE(at, std::string::npos) << header;
    return vtk.data() + at + header.size();
  };
  char const* const points = after("POINTS 9 float\n");
  char const* const ids = after("SCALARS id int 1\nLOOKUP_TABLE default\n");
  char const* const radii = after("SCALARS radius float 1\nLOOKUP_TABLE default\n");
  char const* const layers = after("SCALARS layer int 1\nLOOKUP_TABLE default\n");
  char const* const velocities = after("VECTORS velocity float\n");
  for (int n = 0; n < count; ++n) {
    EXPECT_FLOAT_EQ(big_endian<float>(points + 12 * n), 9.5 - n);
    EXPECT_EQ(big_endian<std::int32_t>(ids + 4 * n), n + 1);
    EXPECT_FLOAT_EQ(big_endian<float>(radii + 4 * n), 0.1);
    EXPECT_EQ(big_endian<std::int32_t>(layers + 4 * n), std::min(n * 3 / 8, 2));
    EXPECT_FLOAT_EQ(big_endian<float>(velocities + 12 * n + 8), -2);
  }

  // A run that goes on lists the earlier pictures too, and knows the layers of the first.
  auto const file = session().scene().directory() / ("piece." + std::to_string(session().rank()));
  {
    State state = State::save(file);
    report.pass(state);
    state.finish();
  }
  ParticleReport again(session());
  State state = State::load(file);
  again.pass(state);
  again.picture(particles(count, moved), 26, 0.7);  // not due
  again.picture(particles(count, moved), 50, 1.0);
  EXPECT_TRUE(content("particles_26.vtk").empty());
  std::string const last = content("particles_50.vtk");
  std::string const header = "SCALARS layer int 1\nLOOKUP_TABLE default\n";
  EXPECT_EQ(last.substr(last.find(header) + header.size(), 4 * count),
            std::string(layers, 4 * count));
  std::string const series = content("particles.vtk.series");
  for (char const* entry : {"{\"name\": \"particles_0.vtk\", \"time\": 0}",
                            "{\"name\": \"particles_25.vtk\", \"time\": 0.5}",
                            "{\"name\": \"particles_50.vtk\", \"time\": 1}"}) {
    EXPECT_NE(series.find(entry), std::string::npos) << series;
  }
}

}  // namespace
