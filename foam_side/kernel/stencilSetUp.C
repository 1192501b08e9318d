// How the spline stencil finds its cells: once, at the start, across ranks and periodic faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "CellStencil.H"

namespace slidewave::foam {
namespace {

constexpr int record_size = 16;  // cell, centre, metric (row by row), reach

struct Extent {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  bool meets(Vec3 const& other_low, Vec3 const& other_high) const {
    return (low.array() <= other_high.array()).all() && (high.array() >= other_low.array()).all();
  }
};

// Where a spline is more than round-off. Cells of a lattice end just where the spline of the next
// but one does: of 125 that touch, 27 count.
Extent extentOf(Vec3 const& centre_m, Vec3 const& reach_m) {
  Vec3 const inside_m = (1 - 1e-9) * reach_m;
  return {centre_m - inside_m, centre_m + inside_m};
}

std::vector<Extent> extentsOfRanks(std::vector<CellShape> const& shapes, MPI_Comm comm, int size) {
  Extent own;
  for (CellShape const& shape : shapes) {
    own.low = own.low.cwiseMin(shape.low_m);
    own.high = own.high.cwiseMax(shape.high_m);
  }
  std::vector<Extent> all(static_cast<std::size_t>(size));
  static_assert(sizeof(Extent) == 6 * sizeof(double));
  MPI_Allgather(&own, 6, MPI_DOUBLE, all.data(), 6, MPI_DOUBLE, comm);
  return all;
}

// Shifts to all periodic images, zero first.
std::vector<Vec3> shifts(Vec3 const& period_m) {
  std::vector<Vec3> result{Vec3::Zero()};
  for (int d = 0; d < 3; ++d) {
    if (period_m[d] <= 0) continue;
    std::size_t const before = result.size();
    for (double const sign : {-1.0, 1.0}) {
      for (std::size_t i = 0; i < before; ++i) {
        result.push_back(result[i] + sign * period_m[d] * Vec3::Unit(d));
      }
    }
  }
  return result;
}

}  // namespace

void CellStencil::addCentre(Vec3 const& centre_m, Eigen::Matrix3d const& metric, int column) {
  auto const tilt = [&](int i, int j) {  // or 0 where it is round-off of the corners' coordinates
    double const twice = 2 * metric(i, j);
    return std::abs(twice) < 1e-12 * std::sqrt(metric(i, i) * metric(j, j)) ? 0 : twice;
  };
  centres_.push_back(
      {{centre_m[0], centre_m[1], centre_m[2]},
       {metric(0, 0), metric(1, 1), metric(2, 2), tilt(0, 1), tilt(0, 2), tilt(1, 2)}});
  column_.push_back(column);
  upright_ = upright_ && tilt(0, 1) == 0 && tilt(0, 2) == 0 && tilt(1, 2) == 0;
}

// Own cells first, then periodic images of own cells, then those of other ranks.
void CellStencil::collectCentres(std::vector<CellShape> const& shapes, Vec3 const& period_m,
                                 MPI_Comm comm, std::vector<Vec3>& reach_m) {
  int rank = 0, size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  auto const extents = extentsOfRanks(shapes, comm, size);
  auto const add = [&](Vec3 const& centre_m, CellShape const& shape, int column) {
    addCentre(centre_m, shape.metric, column);
    reach_m.push_back(shape.reach_m);
  };
  centres_.reserve(shapes.size());
  for (int cell = 0; cell < cells_; ++cell) add(shapes[cell].centre_m, shapes[cell], cell);
  std::vector<std::vector<double>> records(static_cast<std::size_t>(size));
  std::vector<std::vector<int>> given(static_cast<std::size_t>(size));
  for (Vec3 const& shift_m : shifts(period_m)) {
    for (int cell = 0; cell < cells_; ++cell) {
      CellShape const& s = shapes[cell];
      Vec3 const centre_m = s.centre_m + shift_m;
      Extent const own = extentOf(centre_m, s.reach_m);
      for (int other = 0; other < size; ++other) {
        if (!extents[other].meets(own.low, own.high)) continue;
        if (other == rank) {
          if (!shift_m.isZero()) add(centre_m, s, cell);
          continue;
        }
        given[other].push_back(cell);
        std::vector<double>& record = records[other];
        record.push_back(cell);
        record.insert(record.end(), centre_m.data(), centre_m.data() + 3);
        record.insert(record.end(), s.metric.data(), s.metric.data() + 9);
        record.insert(record.end(), s.reach_m.data(), s.reach_m.data() + 3);
      }
    }
  }
  std::vector<int> ours(static_cast<std::size_t>(size)), theirs(ours);
  for (int other = 0; other < size; ++other) ours[other] = static_cast<int>(given[other].size());
  MPI_Alltoall(ours.data(), 1, MPI_INT, theirs.data(), 1, MPI_INT, comm);
  for (int other = 0; other < size; ++other) {
    if (ours[other] == 0 && theirs[other] == 0) continue;
    std::vector<double> received(static_cast<std::size_t>(theirs[other]) * record_size);
    MPI_Sendrecv(records[other].data(), static_cast<int>(records[other].size()), MPI_DOUBLE, other,
                 2, received.data(), static_cast<int>(received.size()), MPI_DOUBLE, other, 2, comm,
                 MPI_STATUS_IGNORE);
    borders_.push_back({other, given[other], cells_ + others_, theirs[other], {}});
    for (int i = 0; i < theirs[other]; ++i) {
      double const* const record = received.data() + static_cast<std::size_t>(i) * record_size;
      addCentre(Vec3(record + 1), Eigen::Matrix3d(record + 4), cells_ + others_ + i);
      reach_m.emplace_back(record + 13);
    }
    others_ += theirs[other];
  }
}

// Centres are sorted into bins of about a cell; each cell asks the bins that its box touches.
void CellStencil::findNeighbours(std::vector<CellShape> const& shapes,
                                 std::vector<Vec3> const& reach_m) {
  auto const extent = [&](std::size_t e) {
    return extentOf(Vec3(centres_[e].centre_m), reach_m[e]);
  };
  Vec3 bin_m = Vec3::Zero();
  for (CellShape const& shape : shapes) bin_m += (shape.high_m - shape.low_m) / cells_;
  bin_m = (2 * bin_m).cwiseMax(1e-300);
  using Bin = std::array<long, 3>;
  auto const forBins = [&](Vec3 const& low, Vec3 const& high, auto const& visit) {
    Eigen::Array3d const from = (low.array() / bin_m.array()).floor();
    Eigen::Array3d const to = (high.array() / bin_m.array()).floor();
    for (double i = from[0]; i <= to[0]; ++i) {
      for (double j = from[1]; j <= to[1]; ++j) {
        for (double k = from[2]; k <= to[2]; ++k) {
          visit(Bin{static_cast<long>(i), static_cast<long>(j), static_cast<long>(k)});
        }
      }
    }
  };
  std::map<Bin, std::vector<int>> bins;
  for (std::size_t e = 0; e < centres_.size(); ++e) {
    Extent const own = extent(e);
    forBins(own.low, own.high, [&](Bin const& bin) { bins[bin].push_back(static_cast<int>(e)); });
  }
  first_.assign(1, 0);
  std::vector<int> found;
  for (CellShape const& shape : shapes) {
    found.clear();
    forBins(shape.low_m, shape.high_m, [&](Bin const& bin) {
      auto const place = bins.find(bin);
      if (place == bins.end()) return;
      for (int const e : place->second) {
        if (extent(e).meets(shape.low_m, shape.high_m)) found.push_back(e);
      }
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    near_.insert(near_.end(), found.begin(), found.end());
    first_.push_back(static_cast<int>(near_.size()));
  }
}

}  // namespace slidewave::foam
