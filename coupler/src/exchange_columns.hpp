// Columns to and from the flat buffers of messages: one block a field, in the layout's order.
#pragma once

#include <algorithm>
#include <vector>

#include "slidewave/table.hpp"

namespace slidewave {

/// Copies rows rows[0..count) of a column to `out`.
void pack(Table::ConstColumn const& column, int const* rows, long count, double* out);

/// Copies a block of `count` particles into rows of a column; of those alone that are `taken`,
/// where it is given: there is one row for each of these.
void unpack(double const* in, int const* rows, long count, Table::Column column,
            char const* taken = nullptr);

/// True where all values are finite. Branch-free: it runs over every value of every message.
bool all_finite(double const* values, long count);

/// The first of `rows` rows with a value that is not finite; -1: none.
long first_not_finite(double const* values, long rows, int components);

/// Writes a block of `count` rows by write(begin, some, out), some rows at a time, so that they are
/// still in the cache when refuse(row) is called for the first that is not finite. Gives the
/// block's end.
template <class Write, class Refuse>
double* pack_block(long count, int components, double* out, Write const& write,
                   Refuse const& refuse) {
  constexpr long at_once = 512;
  for (long begin = 0; begin < count; begin += at_once) {
    long const some = std::min(at_once, count - begin);
    write(begin, some, out);
    long const bad = first_not_finite(out, some, components);
    if (bad >= 0) {
      refuse(begin + bad);
    }
    out += some * components;
  }
  return out;
}

/// "position (x y z) m, radius r m", for messages about a particle.
std::string place_of(Table const& particles, long row);

}  // namespace slidewave
