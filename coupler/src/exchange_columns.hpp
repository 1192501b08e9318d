// Columns to and from the flat buffers of messages: one block a field, in the layout's order.
#pragma once

#include <vector>

#include "slidewave/table.hpp"

namespace slidewave {

/// As many rows of a block are looked at again before others are touched.
constexpr long rows_in_cache = 512;

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

/// "position (x y z) m, radius r m", for messages about a particle.
std::string place_of(Table const& particles, long row);

}  // namespace slidewave
