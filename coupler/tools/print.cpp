#include "print.hpp"

#include <fmt/format.h>

namespace slidewave::preflight {
namespace {

std::string shown(std::optional<double> const& value) {
  return value ? fmt::format("{:.4g}", *value) : "";
}

nlohmann::json or_null(std::optional<double> const& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

}  // namespace

std::string as_table(Sheet const& sheet) {
  std::string text = fmt::format("{:<5} {:<50} {:>10} {:>10} {:>8}  {}\n", "", "quantity", "value",
                                 "limit", "margin", "source");
  for (Row const& row : sheet.rows()) {
    std::string const margin = row.margin ? fmt::format("{:.2g}x", *row.margin) : "";
    text += fmt::format("{:<5} {:<50} {:>10} {:>10} {:>8}  {}\n", row.verdict, row.quantity,
                        shown(row.value), shown(row.limit), margin, row.source);
    if (!row.key.empty()) {
      text += fmt::format("      change {}{}\n", row.key,
                          row.works ? fmt::format(" = {:.4g}", *row.works) : "");
    }
  }
  return text;
}

nlohmann::json as_json(Sheet const& sheet) {
  nlohmann::json list = nlohmann::json::array();
  for (Row const& row : sheet.rows()) {
    list.push_back({{"quantity", row.quantity},
                    {"value", or_null(row.value)},
                    {"limit", or_null(row.limit)},
                    {"margin", or_null(row.margin)},
                    {"verdict", row.verdict},
                    {"source", row.source},
                    {"key", row.key},
                    {"works", or_null(row.works)}});
  }
  return list;
}

}  // namespace slidewave::preflight
