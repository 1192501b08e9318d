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

void weightsOf(SplineCentre const* centres, int const* near, int count, int own, int active,
               double const* points_m, double* weights) {
  for (int from = 0; from < active; from += width) {
    Pack const px = load(points_m + from), py = load(points_m + lanes + from),
               pz = load(points_m + 2 * lanes + from);
    double* const out = weights + from;
    Pack sum = none;
    for (int k = 0; k < count; ++k) {
      double const* const centre = centres[near[k]].centre_m;
      double const* const m = centres[near[k]].metric;
      Pack const x = px - centre[0], y = py - centre[1], z = pz - centre[2];
      Pack const w = spline(positive(x * (m[0] * x + m[3] * y + m[4] * z) +
                                     y * (m[1] * y + m[5] * z) + m[2] * z * z));
      store(out + lanes * k, w);
      sum += w;
    }
    Pack const scale = sum < 1e-9 ? none : 1 / sum;
    for (int k = 0; k < count; ++k) store(out + lanes * k, scale * load(out + lanes * k));
    Pack const all = scale == none ? none + 1 : none;
    store(out + lanes * own, all + load(out + lanes * own));
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

void takeShares(double const* weights, int const* columns, int count, int active,
                double const* fields, int components, double* values) {
  if (components == 1) return takeOne(weights, columns, count, active, fields, values);
  for (int c = 0; c < components; c += 4) {
    for (int from = 0; from < active; from += width) {
      Pack a = none, b = none, d = none, e = none;
      for (int k = 0; k < count; ++k) {
        double const* const field = fields + static_cast<long>(components) * columns[k] + c;
        Pack const w = load(weights + lanes * k + from);
        a += w * field[0];
        b += w * field[1];
        d += w * field[2];
        e += w * field[3];
      }
      store(values + lanes * c + from, a);
      store(values + lanes * (c + 1) + from, b);
      store(values + lanes * (c + 2) + from, d);
      store(values + lanes * (c + 3) + from, e);
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
  for (int k = 0; k < count; ++k) {
    double const* const w = weights + lanes * k;
    double* const field = fields + static_cast<long>(components) * columns[k];
    for (int c = 0; c < components; c += width) {
      Pack even = load(field + c), odd = none;
      for (int l = 0; l < lanes; l += 2) {
        even += w[l] * load(values + components * l + c);
        odd += w[l + 1] * load(values + components * (l + 1) + c);
      }
      store(field + c, even + odd);
    }
  }
}

void pullOne(Pull const* pulls, int const* first, int cells, double const* from, double* to) {
  for (int cell = 0; cell < cells; ++cell) {
    double const here = from[cell];
    double sum = here;
    for (int k = first[cell]; k < first[cell + 1]; ++k) {
      sum += pulls[k].share * (from[pulls[k].column] - here);
    }
    to[cell] = sum;
  }
}

void pullStep(Pull const* pulls, int const* first, int cells, double const* from, int components,
              double* to) {
  if (components == 1) return pullOne(pulls, first, cells, from, to);
  for (int cell = 0; cell < cells; ++cell) {
    long const row = static_cast<long>(components) * cell;
    for (int c = 0; c < components; c += width) {
      Pack const here = load(from + row + c);
      Pack sum = here;
      for (int k = first[cell]; k < first[cell + 1]; ++k) {
        long const other = static_cast<long>(components) * pulls[k].column;
        sum += pulls[k].share * (load(from + other + c) - here);
      }
      store(to + row + c, sum);
    }
  }
}

}  // namespace

extern LaneLoops const loops;
LaneLoops const loops{weightsOf, takeShares, addShares, pullStep};

}  // namespace slidewave::foam::SLIDEWAVE_LANES
