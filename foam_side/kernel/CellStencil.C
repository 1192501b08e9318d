#include <cmath>

#include "CellStencil.H"

namespace slidewave::foam {

double quadraticSpline(double r) {
  if (r < 0.5) return 0.75 - r * r;
  if (r < spline_reach) return 0.5 * (spline_reach - r) * (spline_reach - r);
  return 0;
}

CellStencil::CellStencil(std::vector<CellShape> const& shapes, Vec3 const& period_m, MPI_Comm comm)
    : cells_(static_cast<int>(shapes.size())), comm_(comm) {
  collectEntries(shapes, period_m, comm);
  findNeighbours(shapes);
}

void CellStencil::shares(Vec3 const& position_m, int cell, std::vector<Share>& out) const {
  if (entries_.empty()) {
    out.push_back({cell, 1});
    return;
  }
  std::size_t const begin = out.size();
  double sum = 0;
  for (int k = first_[cell]; k < first_[cell + 1]; ++k) {
    Entry const& entry = entries_[near_[k]];
    Vec3 const offset_m = position_m - entry.centre_m;
    double const weight = quadraticSpline(std::sqrt(offset_m.dot(entry.metric * offset_m)));
    if (weight > 0) out.push_back({entry.cell, weight});
    sum += weight;
  }
  if (sum < 1e-9) {  // far outside a thin cell
    out.resize(begin);
    out.push_back({cell, 1});
    return;
  }
  for (std::size_t i = begin; i < out.size(); ++i) out[i].weight /= sum;
}

Eigen::MatrixXd CellStencil::withOthers(Eigen::MatrixXd const& values) const {
  if (borders_.empty()) return values;
  Eigen::MatrixXd all(values.rows(), cells_ + others_);
  all.leftCols(cells_) = values;
  std::vector<MPI_Request> requests;
  std::vector<Eigen::MatrixXd> sent;
  sent.reserve(borders_.size());
  for (Border const& border : borders_) {
    sent.push_back(values(Eigen::all, border.ours));
    requests.resize(requests.size() + 2);
    MPI_Irecv(all.col(border.first).data(), static_cast<int>(border.count * values.rows()),
              MPI_DOUBLE, border.rank, 0, comm_, &requests.end()[-2]);
    MPI_Isend(sent.back().data(), static_cast<int>(sent.back().size()), MPI_DOUBLE, border.rank, 0,
              comm_, &requests.end()[-1]);
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return all;
}

Eigen::MatrixXd CellStencil::collected(Eigen::MatrixXd const& amounts) const {
  Eigen::MatrixXd own = amounts.leftCols(cells_);
  std::vector<MPI_Request> requests;
  std::vector<Eigen::MatrixXd> received;
  received.reserve(borders_.size());
  for (Border const& border : borders_) {
    received.emplace_back(amounts.rows(), static_cast<long>(border.ours.size()));
    requests.resize(requests.size() + 2);
    MPI_Irecv(received.back().data(), static_cast<int>(received.back().size()), MPI_DOUBLE,
              border.rank, 1, comm_, &requests.end()[-2]);
    MPI_Isend(amounts.col(border.first).data(), static_cast<int>(border.count * amounts.rows()),
              MPI_DOUBLE, border.rank, 1, comm_, &requests.end()[-1]);
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    std::vector<int> const& ours = borders_[i].ours;
    for (std::size_t k = 0; k < ours.size(); ++k) {
      own.col(ours[k]) += received[i].col(static_cast<long>(k));
    }
  }
  return own;
}

}  // namespace slidewave::foam
