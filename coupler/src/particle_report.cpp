#include "slidewave/particle_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "particle_pictures.hpp"
#include "slidewave/physics/limits/overlap.hpp"

namespace slidewave {
namespace {

constexpr long steps_between_looks = 10;

void sum_over_ranks(double* values, int count, MPI_Comm comm) {
  MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, comm);
}

}  // namespace

ParticleReport::ParticleReport(Session const& session)
    : session_(session),
      overlap_limit_(session.scene().number("dem.overlap_limit", limits::unbearable_overlap)) {
  Scene const& scene = session.scene();
  if (scene.number("output.interval", 0.0) > 0) {
    pictures_ = std::make_unique<Pictures>(session);
  }
  if (!scene.has("observe")) {
    return;
  }
  for (std::string const& name : scene.keys("observe")) {
    std::string const type = scene.text("observe." + name + ".type");
    slide_ = slide_ || type == "slide";
    if (type == "particle") {
      followed_.push_back({name, scene.number("observe." + name + ".id")});
    }
  }
}

ParticleReport::~ParticleReport() = default;

void ParticleReport::add_columns(Table& particles) {
  for (Field const& field : {Field{"id", "-", 1},
                             {"position", "m", 3},
                             {"velocity", "m/s", 3},
                             {"angular_velocity", "rad/s", 3},
                             {"radius", "m", 1},
                             {"mass", "kg", 1}}) {
    particles.add(field);
  }
}

bool ParticleReport::wants_particles() const {
  return slide_ || !followed_.empty() || pictures_;
}

bool ParticleReport::wants_overlap(long steps) {
  overlap_wanted_ = slide_ || steps >= next_look_;
  if (overlap_wanted_) {
    next_look_ = steps + steps_between_looks;
  }
  return overlap_wanted_;
}

void ParticleReport::watch(double overlap) {
  if (overlap > overlap_limit_) {
    session_.fail(
        fmt::format("particles overlap by {:.3g} % of the smaller diameter, above "
                    "dem.overlap_limit = {:g}: contacts are too soft for the load or the "
                    "impact (parameters.kn), or parameters.dem_dt is too long for them",
                    100 * overlap, overlap_limit_));
  }
  if (overlap > limits::largest_overlap && !overlap_told_) {
    overlap_told_ = true;
    session_.say(
        fmt::format("warning: particles overlap by {:.3g} % of the smaller diameter; "
                    "stiffer contacts (parameters.kn) keep them spheres",
                    100 * overlap));
  }
}

std::vector<Quantity> ParticleReport::observe(Table const& particles, double max_overlap) {
  std::vector<Quantity> values;
  if (slide_ || overlap_wanted_) {
    MPI_Allreduce(MPI_IN_PLACE, &max_overlap, 1, MPI_DOUBLE, MPI_MAX, session_.comm());
    watch(max_overlap);
    overlap_wanted_ = false;
  }
  if (slide_) {
    observe_slide(particles, max_overlap, values);
  }
  for (Particle const& particle : followed_) {
    auto const id = particles["id"];
    std::array<double, 7> row{};  // position, velocity, how many have the id
    for (long i = 0; i < particles.size(); ++i) {
      if (id(0, i) == particle.id) {
        Eigen::Map<Vec3>(row.data()) = particles["position"].col(i);
        Eigen::Map<Vec3>(row.data() + 3) = particles["velocity"].col(i);
        row[6] += 1;
      }
    }
    sum_over_ranks(row.data(), 7, session_.comm());
    if (!checked_ && row[6] != 1) {
      throw InputError((session_.scene().directory() / "case.toml").string(),
                       "observe." + particle.name + ".id", std::to_string(std::lround(particle.id)),
                       "give the id of a particle of the scene");
    }
    char const* const suffixes[6] = {"_x_m", "_y_m", "_z_m", "_vx_m_s", "_vy_m_s", "_vz_m_s"};
    for (std::size_t k = 0; k < 6; ++k) {
      values.push_back({particle.name + suffixes[k], row[k]});
    }
  }
  checked_ = true;
  return values;
}

void ParticleReport::observe_slide(Table const& particles, double max_overlap,
                                   std::vector<Quantity>& out) const {
  auto const mass = particles["mass"];
  auto const velocity = particles["velocity"];
  auto const spin = particles["angular_velocity"];
  auto const radius = particles["radius"];
  std::array<double, 3> sums{};  // mass, mass times speed, kinetic energy
  for (long i = 0; i < particles.size(); ++i) {
    double const inertia = 0.4 * radius(0, i) * radius(0, i);  // of a sphere, per mass
    sums[0] += mass(0, i);
    sums[1] += mass(0, i) * velocity.col(i).norm();
    sums[2] +=
        0.5 * mass(0, i) * (velocity.col(i).squaredNorm() + inertia * spin.col(i).squaredNorm());
  }
  sum_over_ranks(sums.data(), 3, session_.comm());
  out.push_back({"slide_speed_m_s", sums[0] > 0 ? sums[1] / sums[0] : 0.0});
  out.push_back({"slide_front_x_m", mass_front_x(particles, 0.99, session_.comm())});
  out.push_back({"kinetic_energy_J", sums[2]});
  out.push_back({"max_overlap", max_overlap});
}

void ParticleReport::picture(Table const& particles, long window, double time_s) {
  if (pictures_) {
    pictures_->write_if_due(particles, window, time_s);
  }
}

void ParticleReport::pass(State& state) {
  if (pictures_) {
    pictures_->pass(state);
  }
}

// Weighs by bins, then refines the bin that holds the front: no sorting, no global list.
double mass_front_x(Table const& particles, double part, MPI_Comm comm) {
  constexpr int bins = 1000;
  auto const mass = particles["mass"];
  auto const x = particles["position"].row(0);
  double range_m[2] = {1e300, 1e300};  // lowest, and minus the highest
  for (long i = 0; i < particles.size(); ++i) {
    range_m[0] = std::min(range_m[0], x[i]);
    range_m[1] = std::min(range_m[1], -x[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, range_m, 2, MPI_DOUBLE, MPI_MIN, comm);
  double low = range_m[0], high = -range_m[1], below = 0, wanted = -1;
  if (low > high) {
    return 0.0;  // no particle anywhere
  }
  for (int pass = 0; pass < 2; ++pass) {
    double const width = (high - low) / bins;
    std::array<double, bins> weight{};
    for (long i = 0; i < particles.size(); ++i) {
      double const place = width > 0 ? (x[i] - low) / width : 0.0;
      bool const last = pass == 0 && place >= bins;
      if (place >= 0 && (place < bins || last)) {
        weight[static_cast<std::size_t>(std::min(place, bins - 1.0))] += mass(0, i);
      }
    }
    sum_over_ranks(weight.data(), bins, comm);
    if (wanted < 0) {
      wanted = part * std::accumulate(weight.begin(), weight.end(), 0.0);
    }
    std::size_t bin = 0;
    while (bin + 1 < bins && below + weight[bin] < wanted) {
      below += weight[bin++];
    }
    low += width * static_cast<double>(bin);
    high = low + width;
  }
  return high;
}

}  // namespace slidewave
