#include "cyclicPolyPatch.H"
#include "graphOfMesh.H"
#include "processorPolyPatch.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace slidewave::foam {

using namespace Foam;

namespace {

double conductance(vector const& area, vector const& distance) {
  return std::max(area & distance, scalar(0)) / magSqr(distance);
}

}  // namespace

MeshGraph graphOfMesh(fvMesh const& mesh, MPI_Comm comm) {
  MeshGraph graph;
  graph.comm = comm;
  graph.volume_m3.assign(mesh.V().begin(), mesh.V().end());
  forAll(mesh.neighbour(), face) {
    label const a = mesh.owner()[face], b = mesh.neighbour()[face];
    graph.links.push_back({a, b, conductance(mesh.faceAreas()[face], mesh.C()[b] - mesh.C()[a])});
  }
  for (fvPatch const& patch : mesh.boundary()) {
    if (!patch.coupled()) continue;
    vectorField const distance(patch.delta());
    labelUList const& cells = patch.faceCells();
    if (isA<processorPolyPatch>(patch.patch())) {
      auto const& processor = refCast<processorPolyPatch const>(patch.patch());
      MeshGraph::Border border{processor.neighbProcNo(), processor.tag() & 0x7fff, {}, {}};
      forAll(cells, i) {
        border.cells.push_back(cells[i]);
        border.conductance.push_back(conductance(patch.Sf()[i], distance[i]));
      }
      graph.borders.push_back(std::move(border));
    } else if (isA<cyclicPolyPatch>(patch.patch())) {
      auto const& cyclic = refCast<cyclicPolyPatch const>(patch.patch());
      if (!cyclic.owner()) continue;  // each pair once
      labelUList const& others = cyclic.neighbPatch().faceCells();
      forAll(cells, i) {
        graph.links.push_back({cells[i], others[i], conductance(patch.Sf()[i], distance[i])});
      }
    } else {
      FatalErrorInFunction << "patch " << patch.name() << ": type " << patch.type()
                           << " is not supported; use cyclic" << exit(FatalError);
    }
  }
  return graph;
}

}  // namespace slidewave::foam
