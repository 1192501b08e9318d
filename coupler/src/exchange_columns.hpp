// Columns to and from the flat buffers of messages: one block a field, in the layout's order.
#pragma once

#include <vector>

#include "slidewave/table.hpp"

namespace slidewave {

/// Copies rows rows[0..count) of a column to `out`. False where a value is not finite.
bool pack(Table::ConstColumn const& column, int const* rows, long count, double* out);

/// Copies a block of `count` particles into rows of a column.
void unpack(double const* in, int const* rows, long count, Table::Column column);

/// True where all values are finite. Branch-free: it runs over every value of every message.
bool all_finite(double const* values, long count);

/// "position (x y z) m, radius r m", for messages about a particle.
std::string place_of(Table const& particles, long row);

}  // namespace slidewave
