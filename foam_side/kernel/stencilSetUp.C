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

// Own cells first, then periodic images of own cells, then those of other ranks.
void CellStencil::collectEntries(std::vector<CellShape> const& shapes, Vec3 const& period_m,
                                 MPI_Comm comm) {
  int rank = 0, size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  auto const extents = extentsOfRanks(shapes, comm, size);
  for (int cell = 0; cell < cells_; ++cell) {
    CellShape const& s = shapes[cell];
    entries_.push_back({s.centre_m, s.metric, s.reach_m, cell});
  }
  std::vector<std::vector<double>> records(static_cast<std::size_t>(size));
  std::vector<std::vector<int>> given(static_cast<std::size_t>(size));
  for (Vec3 const& shift_m : shifts(period_m)) {
    for (int cell = 0; cell < cells_; ++cell) {
      CellShape const& s = shapes[cell];
      Vec3 const centre_m = s.centre_m + shift_m;
      for (int other = 0; other < size; ++other) {
        if (!extents[other].meets(centre_m - s.reach_m, centre_m + s.reach_m)) continue;
        if (other == rank) {
          if (!shift_m.isZero()) entries_.push_back({centre_m, s.metric, s.reach_m, cell});
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
    borders_.push_back({other, given[other], cells_ + others_, theirs[other]});
    for (int i = 0; i < theirs[other]; ++i) {
      double const* const record = received.data() + static_cast<std::size_t>(i) * record_size;
      entries_.push_back(
          {Vec3(record + 1), Eigen::Matrix3d(record + 4), Vec3(record + 13), cells_ + others_ + i});
    }
    others_ += theirs[other];
  }
}

// Entries are sorted into bins of about a cell; each cell asks the bins that its box touches.
void CellStencil::findNeighbours(std::vector<CellShape> const& shapes) {
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
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    Entry const& entry = entries_[e];
    forBins(entry.centre_m - entry.reach_m, entry.centre_m + entry.reach_m,
            [&](Bin const& bin) { bins[bin].push_back(static_cast<int>(e)); });
  }
  first_.assign(1, 0);
  std::vector<int> found;
  for (CellShape const& shape : shapes) {
    found.clear();
    forBins(shape.low_m, shape.high_m, [&](Bin const& bin) {
      auto const place = bins.find(bin);
      if (place == bins.end()) return;
      for (int const e : place->second) {
        Vec3 const& c = entries_[e].centre_m;
        Vec3 const& r = entries_[e].reach_m;
        if (Extent{c - r, c + r}.meets(shape.low_m, shape.high_m)) found.push_back(e);
      }
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    near_.insert(near_.end(), found.begin(), found.end());
    first_.push_back(static_cast<int>(near_.size()));
  }
}

}  // namespace slidewave::foam
