#include <cfloat>
#include <cmath>
#include <limits>

#include "Locator.H"
#include "indexedOctree.H"
#include "treeDataCell.H"
#include "treeDataFace.H"

namespace slidewave::foam {

using namespace Foam;

Locator::Locator(fvMesh const& mesh)
    : mesh_(mesh),
      search_(mesh, polyMesh::FACE_PLANES),
      solved_(mesh.geometricD()),
      middle_(mesh.bounds().midpoint()),
      cells_(mesh.cells()),
      owner_(mesh.faceOwner()),
      areas_(mesh.faceAreas()),
      centres_(mesh.faceCentres()) {
  search_.boundaryTree();  // built here, by all ranks
  search_.cellTree();
  inner_.reserve(mesh_.nCells());
  for (label cell = 0; cell < mesh_.nCells(); ++cell) inner_.push_back(innerBox(cell));
}

// Spanned by the centres of the faces, rounded inwards; a cell is convex, so corners tell.
Locator::InnerBox Locator::innerBox(label cell) const {
  boundBox const span(pointField(centres_, cells_[cell]), /*reduce=*/false);
  InnerBox box;
  for (direction d = 0; d < vector::nComponents; ++d) {
    box.low_m[d] = std::nextafter(static_cast<float>(span.min()[d]), FLT_MAX);
    box.high_m[d] = std::nextafter(static_cast<float>(span.max()[d]), -FLT_MAX);
  }
  for (int corner = 0; corner < 8; ++corner) {
    point position;
    for (direction d = 0; d < vector::nComponents; ++d) {
      position[d] = corner >> d & 1 ? box.high_m[d] : box.low_m[d];
    }
    if (exitFace(position, cell) >= 0) return {{1, 1, 1}, {0, 0, 0}};
  }
  return box;
}

point Locator::inSlab(Vec3 const& position_m) const {
  point inside(position_m.x(), position_m.y(), position_m.z());
  for (direction d = 0; d < vector::nComponents; ++d) {
    if (solved_[d] < 0) inside[d] = middle_[d];
  }
  return inside;
}

// The face of `cell` whose plane the point lies farthest beyond, or -1 where it is inside all. Most
// points are: the sign of the distance does, and no root is taken.
label Locator::exitFace(point const& position, label cell) const {
  label exit = -1;
  scalar farthest = 0;
  for (label const face : cells_[cell]) {
    vector const& area = areas_[face];
    scalar beyond = (position - centres_[face]) & area;
    if (owner_[face] != cell) beyond = -beyond;
    if (beyond > 0 && (beyond /= mag(area)) > farthest) {
      farthest = beyond;
      exit = face;
    }
  }
  return exit;
}

label Locator::walk(point const& position, label cell) const {
  for (int step = 0; step < 64; ++step) {
    label const face = exitFace(position, cell);
    if (face < 0) return cell;
    if (!mesh_.isInternalFace(face)) return -1;
    cell = owner_[face] == cell ? mesh_.faceNeighbour()[face] : owner_[face];
  }
  return -1;
}

Home Locator::locate(Vec3 const& position_m, int hint_cell) const {
  if (mesh_.nCells() == 0) return {};
  point const position = inSlab(position_m);
  if (hint_cell >= 0 && hint_cell < mesh_.nCells()) {
    if (inner_[hint_cell].contains(position)) return {hint_cell, 0};
    label const cell = walk(position, hint_cell);
    if (cell >= 0) return {cell, 0};
  }
  if (mesh_.bounds().contains(position)) {
    label const cell = search_.cellTree().findInside(position);
    if (cell >= 0) return {cell, 0};
  }
  // The tree holds every face that bounds this rank's part, faces to other ranks included.
  pointIndexHit const hit = search_.boundaryTree().findNearest(position, Foam::sqr(GREAT));
  if (!hit.hit()) return {};
  label const face = search_.boundaryTree().shapes().faceLabels()[hit.index()];
  return {mesh_.faceOwner()[face], mag(hit.hitPoint() - position)};
}

Box Locator::bounds() const {
  Box box;
  if (mesh_.nCells() == 0) return box;
  boundBox const own(mesh_.points(), /*reduce=*/false);
  for (direction d = 0; d < vector::nComponents; ++d) {
    bool const open = solved_[d] < 0;
    box.low[d] = open ? -std::numeric_limits<double>::max() : own.min()[d];
    box.high[d] = open ? std::numeric_limits<double>::max() : own.max()[d];
  }
  return box;
}

}  // namespace slidewave::foam
