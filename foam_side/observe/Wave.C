#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "LargeBodies.H"
#include "Wave.H"

namespace slidewave::foam {

using namespace Foam;

namespace {

double const noValue = std::numeric_limits<double>::quiet_NaN();

// Water volume per height bin, which ranks can add up.
double percentile99(WaterView const& view, std::vector<char> const& chosen, double low,
                    double high) {
  int const bins = 4096;
  double const width = std::max(high - low, 1e-12) / bins;
  std::vector<double> volume(bins, 0.0);
  for (label cell = 0; cell < view.mesh.nCells(); ++cell) {
    if (!chosen[cell]) continue;
    double const height = view.mesh.C()[cell].z();
    int const bin = std::clamp(static_cast<int>((height - low) / width), 0, bins - 1);
    volume[bin] += view.water[cell] * view.mesh.V()[cell];
  }
  MPI_Allreduce(MPI_IN_PLACE, volume.data(), bins, MPI_DOUBLE, MPI_SUM, view.graph.comm);
  double const all = std::accumulate(volume.begin(), volume.end(), 0.0);
  double below = 0;
  for (int bin = 0; bin < bins; ++bin) {
    below += volume[bin];
    if (below >= 0.99 * all) return low + (bin + 1) * width;
  }
  return high;
}

}  // namespace

std::vector<char> lake(WaterView const& view, double threshold) {
  int const cells = view.graph.cells();
  std::vector<char> wet(cells);
  Eigen::MatrixXd water_m3(1, cells);
  for (int cell = 0; cell < cells; ++cell) {
    wet[cell] = view.water[cell] >= threshold;
    water_m3(0, cell) = view.water[cell] * view.mesh.V()[cell];
  }
  return largeBodies(view.graph, wet, water_m3, 0.05);
}

Wave::Wave(Scene const& scene, std::string name)
    : name_(std::move(name)),
      level_m_(scene.number("observe." + name_ + ".level")),
      bank_x_m_(scene.number("observe." + name_ + ".bank_x")) {}

std::vector<Quantity> Wave::observe(WaterView const& view) const {
  double height[2], lowest = GREAT, height99 = noValue;
  double const thresholds[] = {0.5, 0.1};
  for (int i = 0; i < 2; ++i) {
    std::vector<char> chosen = lake(view, thresholds[i]);
    double top = -GREAT;
    for (label cell = 0; cell < view.mesh.nCells(); ++cell) {
      chosen[cell] = chosen[cell] && view.mesh.C()[cell].x() > bank_x_m_;
      if (!chosen[cell]) continue;
      top = std::max(top, view.mesh.C()[cell].z());
      lowest = std::min(lowest, view.mesh.C()[cell].z());
    }
    reduce(top, maxOp<scalar>());
    reduce(lowest, minOp<scalar>());
    height[i] = top > -GREAT ? top - level_m_ : noValue;
    if (i == 0 && top > -GREAT) height99 = percentile99(view, chosen, lowest, top) - level_m_;
  }

  double cells = 0, weight = 0, momentum = 0;
  for (label cell = 0; cell < view.mesh.nCells(); ++cell) {
    if (view.eps[cell] <= 0.9 || view.water[cell] < 0.5 || view.mesh.C()[cell].z() <= level_m_) {
      continue;
    }
    double const volume = view.water[cell] * view.mesh.V()[cell];
    cells += 1;
    weight += volume;
    momentum += volume * mag(view.velocity[cell]);
  }
  reduce(cells, sumOp<scalar>());
  reduce(weight, sumOp<scalar>());
  reduce(momentum, sumOp<scalar>());
  return {{name_ + "_height_m", height[0]},
          {name_ + "_splash_m", height[1]},
          {name_ + "_height_99_m", height99},
          {name_ + "_speed_m_s", cells < 10 ? noValue : momentum / weight}};
}

}  // namespace slidewave::foam
