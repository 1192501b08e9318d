#include <Eigen/LU>

#include "cyclicPolyPatch.H"
#include "fvMesh.H"
#include "graphOfMesh.H"
#include "processorCyclicPolyPatch.H"

namespace slidewave::foam {

using namespace Foam;

namespace {

// Sum of a_k a_k^T over the edges of the parallelepiped with this spread of corners.
Eigen::Matrix3d edgeTensor(pointField const& corners) {
  vector const middle = average(corners);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (point const& corner : corners) {
    Vec3 const offset(corner.x() - middle.x(), corner.y() - middle.y(), corner.z() - middle.z());
    sum += offset * offset.transpose();
  }
  return sum * (4.0 / corners.size());
}

}  // namespace

std::vector<CellShape> shapesOfCells(fvMesh const& mesh) {
  std::vector<CellShape> shapes(mesh.nCells());
  forAll(mesh.cells(), cell) {
    CellShape& shape = shapes[cell];
    pointField const corners(mesh.cells()[cell].points(mesh.faces(), mesh.points()));
    boundBox const box(corners, /*reduce=*/false);
    Eigen::Matrix3d edges = edgeTensor(corners);
    for (direction d = 0; d < vector::nComponents; ++d) {
      shape.centre_m[d] = mesh.cellCentres()[cell][d];
      shape.low_m[d] = box.min()[d];
      shape.high_m[d] = box.max()[d];
      shape.reach_m[d] = spline_reach * std::sqrt(edges(d, d));
    }
    for (direction d = 0; d < vector::nComponents; ++d) {
      if (mesh.geometricD()[d] > 0) continue;
      edges.row(d).setZero();
      edges.col(d).setZero();
      edges(d, d) = 1;
    }
    shape.metric = edges.inverse();
    for (direction d = 0; d < vector::nComponents; ++d) {
      if (mesh.geometricD()[d] < 0) shape.metric(d, d) = 0;
    }
  }
  return shapes;
}

Vec3 periodOfMesh(fvMesh const& mesh, MPI_Comm comm) {
  Vec3 periodic = Vec3::Zero();
  for (polyPatch const& patch : mesh.boundaryMesh()) {
    if (!isA<cyclicPolyPatch>(patch) && !isA<processorCyclicPolyPatch>(patch)) continue;
    vector const area = cmptMag(sum(patch.faceAreas()));
    for (direction d = 0; d < vector::nComponents; ++d) {
      if (area[d] > 0.9 * mag(area)) periodic[d] = 1;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, periodic.data(), 3, MPI_DOUBLE, MPI_MAX, comm);
  vector const span = mesh.bounds().span();
  return periodic.cwiseProduct(Vec3(span.x(), span.y(), span.z()));
}

double meanSquaredCellSize(fvMesh const& mesh, MPI_Comm comm) {
  double sums[2] = {0, static_cast<double>(mesh.nCells())};
  forAll(mesh.cells(), cell) {
    Eigen::Matrix3d const edges =
        edgeTensor(mesh.cells()[cell].points(mesh.faces(), mesh.points()));
    for (direction d = 0; d < vector::nComponents; ++d) {
      if (mesh.geometricD()[d] > 0) sums[0] += edges(d, d) / mesh.nGeometricD();
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, comm);
  return sums[0] / sums[1];
}

}  // namespace slidewave::foam
