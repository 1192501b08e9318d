// Compiled once a set of instructions, into the namespace SLIDEWAVE_LANES (see CMakeLists.txt).
#include <cmath>
#include <cstring>

#include "lanes.H"

namespace slidewave::foam::SLIDEWAVE_LANES {
namespace {

#ifdef __AVX2__
constexpr int width = 4;
#else
constexpr int width = 2;
#endif
using Pack = double __attribute__((vector_size(width * sizeof(double))));
constexpr Pack none{};

inline Pack load(double const* from) {
  Pack pack;
  std::memcpy(&pack, from, sizeof pack);
  return pack;
}

inline void store(double* to, Pack pack) {
  std::memcpy(to, &pack, sizeof pack);
}

inline Pack positive(Pack pack) {
  return pack > none ? pack : none;
}

inline Pack root(Pack pack) {
  for (int l = 0; l < width; ++l) pack[l] = std::sqrt(pack[l]);
  return pack;
}

// The quadratic spline, 3/4 - r^2 near the centre and (3/2 - r)^2/2 beyond 1/2, in one formula.
inline Pack spline(Pack square) {
  Pack const r = root(square), outer = positive(spline_reach - r), inner = positive(0.5 - r);
  return 0.5 * outer * outer - 1.5 * inner * inner;
}

/// Of `packs` packs of points at once: a cell is looked up once, and their roots overlap.
template <int packs, bool upright>
void weightsOfPacks(SplineCentre const* centres, int const* near, int count, int own,
                    double const* points_m, double* weights) {
  Pack px[packs], py[packs], pz[packs], sum[packs] = {};
  for (int p = 0; p < packs; ++p) {
    px[p] = load(points_m + width * p);
    py[p] = load(points_m + lanes + width * p);
    pz[p] = load(points_m + 2 * lanes + width * p);
  }
  for (int k = 0; k < count; ++k) {
    double const* const centre = centres[near[k]].centre_m;
    double const* const m = centres[near[k]].metric;
    for (int p = 0; p < packs; ++p) {
      Pack const x = px[p] - centre[0], y = py[p] - centre[1], z = pz[p] - centre[2];
      Pack square = m[0] * x * x + m[1] * y * y + m[2] * z * z;
      if (!upright) square = positive(square + x * (m[3] * y + m[4] * z) + m[5] * y * z);
      Pack const w = spline(square);
      store(weights + lanes * k + width * p, w);
      sum[p] += w;
    }
  }
  Pack scale[packs];
  for (int p = 0; p < packs; ++p) scale[p] = sum[p] < 1e-9 ? none : 1 / sum[p];
  for (int k = 0; k < count; ++k) {
    double* const out = weights + lanes * k;
    for (int p = 0; p < packs; ++p) store(out + width * p, scale[p] * load(out + width * p));
  }
  for (int p = 0; p < packs; ++p) {
    double* const out = weights + lanes * own + width * p;
    store(out, load(out) + (scale[p] == none ? none + 1 : none));
  }
}

template <bool upright>
void weightsOf(SplineCentre const* centres, int const* near, int count, int own, int active,
               double const* points_m, double* weights) {
  for (int from = 0; from < active; from += 2 * width) {
    auto const some =
        active - from > width ? weightsOfPacks<2, upright> : weightsOfPacks<1, upright>;
    some(centres, near, count, own, points_m + from, weights + from);
  }
}

void takeOne(double const* weights, int const* columns, int count, int active, double const* fields,
             double* values) {
  for (int from = 0; from < active; from += width) {
    Pack sum = none;
    for (int k = 0; k < count; ++k) sum += load(weights + lanes * k + from) * fields[columns[k]];
    store(values + from, sum);
  }
}

/// Four components from `field` on, of `packs` packs of particles.
template <int packs>
void takeFour(double const* weights, int const* columns, int count, double const* fields,
              int components, double* values) {
  Pack sum[4][packs] = {};
  for (int k = 0; k < count; ++k) {
    double const* const field = fields + static_cast<long>(components) * columns[k];
    for (int p = 0; p < packs; ++p) {
      Pack const w = load(weights + lanes * k + width * p);
      for (int c = 0; c < 4; ++c) sum[c][p] += w * field[c];
    }
  }
  for (int c = 0; c < 4; ++c) {
    for (int p = 0; p < packs; ++p) store(values + lanes * c + width * p, sum[c][p]);
  }
}

void takeShares(double const* weights, int const* columns, int count, int active,
                double const* fields, int components, double* values) {
  if (components == 1) return takeOne(weights, columns, count, active, fields, values);
  for (int from = 0; from < active; from += 2 * width) {
    auto const some = active - from > width ? takeFour<2> : takeFour<1>;
    for (int c = 0; c < components; c += 4) {
      some(weights + from, columns, count, fields + c, components, values + lanes * c + from);
    }
  }
}

void addOne(double const* weights, int const* columns, int count, double const* values,
            double* fields) {
  for (int k = 0; k < count; ++k) {
    Pack sum = none;
    for (int l = 0; l < lanes; l += width) sum += load(weights + lanes * k + l) * load(values + l);
    double total = 0;
    for (int l = 0; l < width; ++l) total += sum[l];
    fields[columns[k]] += total;
  }
}

void addShares(double const* weights, int const* columns, int count, double const* values,
               int components, double* fields) {
  if (components == 1) return addOne(weights, columns, count, values, fields);
  for (int c = 0; c < components; c += width) {
    Pack value[lanes];
    for (int l = 0; l < lanes; ++l) value[l] = load(values + components * l + c);
    for (int k = 0; k < count; ++k) {
      double const* const w = weights + lanes * k;
      double* const field = fields + static_cast<long>(components) * columns[k] + c;
      Pack even = load(field), odd = none;
      for (int l = 0; l < lanes; l += 2) {
        even += w[l] * value[l];
        odd += w[l + 1] * value[l + 1];
      }
      store(field, even + odd);
    }
  }
}

void pullOne(Pull const* pulls, int const* first, CellRun cells, double const* from, double* to) {
  for (int cell = cells.begin; cell < cells.end; ++cell) {
    double const here = from[cell];
    double sum = here;
    for (int k = first[cell]; k < first[cell + 1]; ++k) {
      sum += pulls[k].share * (from[pulls[k].column] - here);
    }
    to[cell] = sum;
  }
}

/// Of 4 x fours components from `from` on.
template <int fours>
void pullFours(Pull const* pulls, int const* first, CellRun cells, double const* from,
               long components, double* to) {
  constexpr int packs = fours * 4 / width;
  for (int cell = cells.begin; cell < cells.end; ++cell) {
    Pack here[packs], sum[packs];
    for (int p = 0; p < packs; ++p) sum[p] = here[p] = load(from + components * cell + width * p);
    for (int k = first[cell]; k < first[cell + 1]; ++k) {
      double const* const other = from + components * pulls[k].column;
      for (int p = 0; p < packs; ++p)
        sum[p] += pulls[k].share * (load(other + width * p) - here[p]);
    }
    for (int p = 0; p < packs; ++p) store(to + components * cell + width * p, sum[p]);
  }
}

void pullStep(Pull const* pulls, int const* first, CellRun cells, double const* from,
              int components, double* to) {
  if (components == 1) return pullOne(pulls, first, cells, from, to);
  for (int c = 0; c < components; c += 12) {
    int const left = components - c;
    auto const some = left == 4 ? pullFours<1> : left == 8 ? pullFours<2> : pullFours<3>;
    some(pulls, first, cells, from + c, components, to + c);
  }
}

}  // namespace

extern LaneLoops const loops;
LaneLoops const loops{weightsOf<false>, weightsOf<true>, takeShares, addShares, pullStep};

}  // namespace slidewave::foam::SLIDEWAVE_LANES
