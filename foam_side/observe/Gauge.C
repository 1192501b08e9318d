#include <algorithm>

#include "Gauge.H"

namespace slidewave::foam {

using namespace Foam;

Gauge::Gauge(Scene const& scene, std::string name, fvMesh const& mesh)
    : name_(std::move(name)), bed_m_(GREAT) {
  point place = mesh.bounds().midpoint();
  place.x() = scene.number("observe." + name_ + ".x");
  place.y() = scene.number("observe." + name_ + ".y", place.y());
  // The part of the line inside a cell lies above all its faces that look down, below those that
  // look up.
  for (label cell = 0; cell < mesh.nCells(); ++cell) {
    double bottom = -GREAT, top = GREAT;
    for (label const face : mesh.cells()[cell]) {
      vector out = mesh.faceAreas()[face] / mag(mesh.faceAreas()[face]);
      if (mesh.faceOwner()[face] != cell) out = -out;
      double const beyond = (place - mesh.faceCentres()[face]) & (out - out.z() * vector(0, 0, 1));
      if (mag(out.z()) < 1e-12) {
        // On a face between two columns the point belongs to the one beyond it.
        if (beyond > 0 || (beyond == 0 && out.x() + out.y() > 0)) top = -GREAT;
        continue;
      }
      double const cut = mesh.faceCentres()[face].z() - beyond / out.z();
      if (out.z() > 0) {
        top = std::min(top, cut);
      } else {
        bottom = std::max(bottom, cut);
      }
    }
    if (top <= bottom) continue;
    line_.push_back({cell, top - bottom});
    bed_m_ = std::min(bed_m_, bottom);
  }
  reduce(bed_m_, minOp<scalar>());
  if (bed_m_ == GREAT) {
    throw InputError((scene.directory() / "case.toml").string(), "observe." + name_ + ".x",
                     std::to_string(place.x()), "lies outside the fluid mesh");
  }
}

std::vector<Quantity> Gauge::observe(WaterView const& view) const {
  double depth = 0;
  for (Piece const& piece : line_)
    depth += view.water[piece.cell] / view.eps[piece.cell] * piece.length_m;
  reduce(depth, sumOp<scalar>());
  return {{name_ + "_level_m", bed_m_ + depth}};
}

}  // namespace slidewave::foam
