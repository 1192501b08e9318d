#include "MeshGraph.H"

namespace slidewave::foam {

std::vector<Eigen::MatrixXd> MeshGraph::across(Eigen::MatrixXd const& values) const {
  std::vector<Eigen::MatrixXd> theirs(borders.size()), ours(borders.size());
  std::vector<MPI_Request> requests(2 * borders.size());
  for (std::size_t i = 0; i < borders.size(); ++i) {
    Border const& border = borders[i];
    ours[i].resize(values.rows(), static_cast<long>(border.cells.size()));
    theirs[i].resizeLike(ours[i]);
    for (std::size_t face = 0; face < border.cells.size(); ++face) {
      ours[i].col(static_cast<long>(face)) = values.col(border.cells[face]);
    }
    int const count = static_cast<int>(ours[i].size());
    MPI_Irecv(theirs[i].data(), count, MPI_DOUBLE, border.rank, border.tag, comm, &requests[2 * i]);
    MPI_Isend(ours[i].data(), count, MPI_DOUBLE, border.rank, border.tag, comm,
              &requests[2 * i + 1]);
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return theirs;
}

}  // namespace slidewave::foam
