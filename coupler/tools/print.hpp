// The sheet as a table for people or as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sheet.hpp"

namespace slidewave::preflight {

/// A line a row; a row that is not ok is followed by the key to change and a value that works.
std::string as_table(Sheet const& sheet);

/// A list of objects with quantity, value, limit, margin, verdict, source, key, works; null where
/// there is none.
nlohmann::json as_json(Sheet const& sheet);

}  // namespace slidewave::preflight
