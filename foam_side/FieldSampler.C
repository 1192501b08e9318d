#include <optional>
#include <stdexcept>

#include "FieldSampler.H"
#include "fvcCurl.H"

namespace slidewave::foam {

using namespace Foam;

namespace {

/// Of the fluid's own motion: shared out by its mass.
bool isWeighted(std::string const& field) {
  return field == "velocity" || field == "mean_velocity" || field == "acceleration" ||
         field == "vorticity";
}

std::optional<double> uniformValue(PorousFlow const& flow, std::string const& field) {
  UniformFluid const* const fluid = flow.uniformFluid();
  if (!fluid) return std::nullopt;
  if (field == "density") return fluid->density_kg_m3;
  if (field == "viscosity") return fluid->viscosity_Pa_s;
  if (field == "saturation") return 1;
  return std::nullopt;
}

}  // namespace

void FieldSampler::weigh() {
  if (weighed_) return;
  scalarField const& eps = flow_.eps();
  weight_.resize(eps.size());
  if (UniformFluid const* const fluid = flow_.uniformFluid()) {
    forAll(eps, cell) weight_[cell] = fluid->density_kg_m3 * eps[cell];
  } else {
    tmp<volScalarField> const density = flow_.density();
    forAll(eps, cell) weight_[cell] = density()[cell] * eps[cell];
  }
  weighed_ = true;
}

void FieldSampler::weighParticles() {
  if (!at_particles_) sample({});
}

void FieldSampler::put(std::string const& field, int row, ParticleKernel::Fields& fields) const {
  auto const scalars = [&](scalarField const& values) {
    forAll(values, cell) fields(row, cell) = values[cell];
  };
  auto const vectors = [&](vectorField const& values) {
    bool const weighted = isWeighted(field);
    forAll(values, cell) {
      double const weight = weighted ? weight_[cell] : 1;
      for (direction d = 0; d < 3; ++d) fields(row + d, cell) = weight * values[cell][d];
    }
  };
  if (field == "velocity") {
    vectors(flow_.U());
  } else if (field == "mean_velocity") {
    vectors(flow_.meanVelocity());
  } else if (field == "density") {
    scalars(flow_.density()());
  } else if (field == "viscosity") {
    scalars(flow_.dynamicViscosity()());
  } else if (field == "void_fraction") {
    scalars(flow_.eps());
  } else if (field == "saturation") {
    scalars(flow_.saturation()());
  } else if (field == "pressure_gradient") {
    vectors(flow_.meanPressureGradient());
  } else if (field == "acceleration") {
    vectors(flow_.meanAcceleration());
  } else if (field == "vorticity") {
    vectors(fvc::curl(flow_.U())());
  } else if (field == "viscous_stress") {
    vectors(flow_.meanViscousStress());
  } else if (field == "drag_reaction") {
    vectors(flow_.meanDragReaction());
  } else {
    throw std::invalid_argument("slidewave_foam has no field " + field);
  }
}

void FieldSampler::sample(std::vector<Sample> const& samples) {
  weigh();
  targets_.clear();
  weight_at_particles_.resize(kernel_.particles());
  if (!at_particles_) targets_.push_back({weight_at_particles_.data(), 1, false});
  for (Sample const& sample : samples) {
    Table::Column out = sample.out;
    if (auto const value = uniformValue(flow_, sample.field)) {
      out.setConstant(*value);
      continue;
    }
    for (long d = 0; d < out.rows(); ++d) {
      targets_.push_back({out.data() + d, out.rows(), isWeighted(sample.field)});
    }
  }
  int const count = static_cast<int>(targets_.size());
  if (count == 0) return;
  ParticleKernel::Fields fields = kernel_.fields(count);
  int row = 0;
  if (!at_particles_) {
    for (long cell = 0; cell < fields.cols(); ++cell) fields(0, cell) = weight_[cell];
    ++row;
  }
  for (Sample const& sample : samples) {
    if (uniformValue(flow_, sample.field)) continue;
    put(sample.field, row, fields);
    row += static_cast<int>(sample.out.rows());
  }
  bool const known = at_particles_;
  kernel_.gather([&](int particle, double const* values, int stride) {
    double const weight = known ? weight_at_particles_[particle] : values[0];
    for (int k = 0; k < count; ++k) {
      Target const& target = targets_[k];
      double const value = values[k * stride];
      target.values[target.step * particle] = target.weighted ? value / weight : value;
    }
  });
  at_particles_ = true;
}

}  // namespace slidewave::foam
