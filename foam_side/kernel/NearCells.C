#include <algorithm>

#include "NearCells.H"

namespace slidewave::foam {
namespace {

/// Marked cells and those that share a face with one; across borders too.
void grow(CellValues& marks, CellValues& spare, Smoother const& smoother) {
  smoother.step(marks, spare, 1, smoother.everywhere());
  for (double& mark : marks) mark = mark > 0 ? 1 : 0;  // no ring is lost to underflow
}

void listRuns(CellValues const& marks, int cells, CellRuns& runs) {
  runs.clear();
  for (int cell = 0; cell < cells; ++cell) {
    if (marks[cell] == 0) continue;
    if (runs.empty() || runs.back().end != cell) runs.push_back({cell, cell});
    runs.back().end = cell + 1;
  }
}

}  // namespace

long NearCells::strangers(std::vector<int> const& first) const {
  if (rings_.size() == 1) return 0;  // nothing is smoothed
  long count = 0;
  for (std::size_t cell = 0; cell < homes_.size(); ++cell) {
    count += homes_[cell] == 0 && first[cell] < first[cell + 1];
  }
  return count;
}

void NearCells::find(std::vector<int> const& first, Smoother const& smoother,
                     CellStencil const& stencil, CellValues& marks, CellValues& spare) {
  int const cells = stencil.cells();
  marks.assign(std::max(smoother.columns(), stencil.columns()), 0.0);
  for (int cell = 0; cell < cells; ++cell) {
    if (first[cell] == first[cell + 1]) continue;
    CellStencil::Around const around = stencil.around(cell);
    for (int k = 0; k < around.count; ++k) marks[around.columns[k]] = 1;
  }
  stencil.collect(marks.data(), 1);
  grow(marks, spare, smoother);  // room to move into the next cell
  stencil.fetch(marks.data(), 1);
  for (int cell = 0; cell < cells; ++cell) {
    CellStencil::Around const around = stencil.around(cell);
    homes_[cell] = std::all_of(around.columns, around.columns + around.count,
                               [&](int column) { return marks[column] > 0; });
  }
  for (std::size_t r = 0; r < rings_.size(); ++r) {
    if (r > 0) grow(marks, spare, smoother);
    listRuns(marks, cells, rings_[r]);
  }
}

// What lies outside a ring stays zero, in both.
void NearCells::spread(Smoother const& smoother, CellValues& values, CellValues& spare,
                       int components) const {
  spare.assign(values.size(), 0.0);
  for (int i = 0; i < smoother.steps(); ++i)
    smoother.step(values, spare, components, rings_[i + 1]);
}

void NearCells::gather(Smoother const& smoother, CellValues& values, CellValues& spare,
                       int components) const {
  int const steps = smoother.steps();
  for (int i = 0; i < steps; ++i) smoother.step(values, spare, components, rings_[steps - 1 - i]);
}

}  // namespace slidewave::foam
