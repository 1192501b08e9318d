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
  steps_ = flow_.steps();
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

// Fields that need no rows of their own: constants, the mean over a single step, and the void
// fraction of one fluid while the weights are made of it.
int FieldSampler::plan(std::vector<Sample> const& samples) {
  UniformFluid const* const fluid = flow_.uniformFluid();
  bool const weightTells = fluid && !at_particles_ && steps_ == flow_.steps();
  bool const oneStep = flow_.steps() == steps_ + 1;
  int rows = at_particles_ ? 0 : 1, velocityRow = -1;
  targets_.clear();
  for (Sample const& sample : samples) {
    Table::Column out = sample.out;
    if (auto const value = uniformValue(flow_, sample.field)) {
      out.setConstant(*value);
      continue;
    }
    Target target{out.data(), static_cast<int>(out.rows()), rows,
                  1,          isWeighted(sample.field),     &sample.field};
    if (sample.field == "velocity" || sample.field == "mean_velocity") {
      if (oneStep && velocityRow >= 0) {
        target.row = velocityRow;
        target.field = nullptr;
      }
      velocityRow = target.row;
    } else if (weightTells && sample.field == "void_fraction") {
      target.row = 0;
      target.factor = 1 / fluid->density_kg_m3;
      target.field = nullptr;
    }
    if (target.field) rows += target.components;
    targets_.push_back(target);
  }
  return rows;
}

bool FieldSampler::prepare(std::vector<Sample> const& samples) {
  weigh();
  share_at_particles_.resize(kernel_.particles());
  int const rows = plan(samples);
  if (rows == 0) return false;
  ParticleKernel::Fields fields = kernel_.fields(rows);
  shares_due_ = !at_particles_;
  for (long cell = 0; shares_due_ && cell < fields.cols(); ++cell) fields(0, cell) = weight_[cell];
  for (Target const& target : targets_) {
    if (target.field) put(*target.field, target.row, fields);
  }
  at_particles_ = true;
  return true;
}

void FieldSampler::sample(std::vector<Sample> const& samples) {
  if (!prepare(samples)) return;
  kernel_.gather(
      [this](int particle, double const* values, int stride) { take(particle, values, stride); });
}

}  // namespace slidewave::foam
