#include "exchange_columns.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

namespace slidewave {
namespace {

template <int components>
void gather_rows(double const* from, int const* rows, long count, double* out) {
  for (long i = 0; i < count; ++i) {
    double const* source = from + static_cast<long>(rows[i]) * components;
    for (int k = 0; k < components; ++k) {
      *out++ = source[k];
    }
  }
}

template <int components>
void scatter_rows(double const* in, int const* rows, long count, double* to, char const* taken) {
  for (long i = 0; i < count; ++i, in += components) {
    if (taken && !taken[i]) {
      continue;
    }
    double* target = to + static_cast<long>(*rows++) * components;
    for (int k = 0; k < components; ++k) {
      target[k] = in[k];
    }
  }
}

}  // namespace

bool all_finite(double const* values, long count) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000ULL, one = 0x0010000000000000ULL;
  std::uint64_t bad = 0;  // where all bits of an exponent are set, one more carries into the sign
  for (long i = 0; i < count; ++i) {
    std::uint64_t bits;
    std::memcpy(&bits, values + i, sizeof bits);
    bad |= (bits & exponent) + one;
  }
  return bad >> 63 == 0;
}

long first_not_finite(double const* values, long rows, int components) {
  if (all_finite(values, rows * components)) {
    return -1;
  }
  long row = 0;
  while (all_finite(values + row * components, components)) {
    ++row;
  }
  return row;
}

void pack(Table::ConstColumn const& column, int const* rows, long count, double* out) {
  if (column.rows() == 3) {
    gather_rows<3>(column.data(), rows, count, out);
  } else {
    gather_rows<1>(column.data(), rows, count, out);
  }
}

void unpack(double const* in, int const* rows, long count, Table::Column column,
            char const* taken) {
  if (column.rows() == 3) {
    scatter_rows<3>(in, rows, count, column.data(), taken);
  } else {
    scatter_rows<1>(in, rows, count, column.data(), taken);
  }
}

std::string place_of(Table const& particles, long row) {
  auto const position = particles["position"].col(row);
  return fmt::format("({:.6g} {:.6g} {:.6g}) m, radius {:.4g} m", position[0], position[1],
                     position[2], particles["radius"](0, row));
}

}  // namespace slidewave
