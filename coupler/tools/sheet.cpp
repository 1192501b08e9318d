#include "sheet.hpp"

#include <algorithm>
#include <cmath>

namespace slidewave::preflight {

bool Sheet::needs(Facts const& facts, std::string const& quantity,
                  std::vector<std::string> const& names) {
  std::string missing;
  for (auto const& name : names) {
    if (!facts.has(name)) {
      missing += (missing.empty() ? "" : ", ") + name;
    }
  }
  if (!missing.empty()) {
    left_out(quantity, "not known: " + missing);
  }
  return missing.empty();
}

void Sheet::left_out(std::string const& quantity, std::string const& reason) {
  Row row;
  row.quantity = quantity;
  row.source = "left out: " + reason;
  rows_.push_back(row);
}

void Sheet::note(std::string const& quantity, double value, std::string const& source) {
  Row row;
  row.quantity = quantity;
  row.value = value;
  row.source = source;
  rows_.push_back(row);
}

void Sheet::at_most(std::string const& quantity, double value, double comfort, double limit,
                    std::string const& source, Remedy const& remedy) {
  if (remedy.key == "coupling.window" && remedy.works && !std::isinf(limit)) {
    longest_window_s_ = std::min(longest_window_s_, *remedy.works);
  }
  double const shown = std::isinf(limit) ? comfort : limit;
  double const margin = value > 0 ? shown / value : INFINITY;
  judge({quantity, value, shown, margin, "", source, "", {}}, value <= comfort, value <= limit,
        remedy);
}

void Sheet::at_least(std::string const& quantity, double value, double comfort, double limit,
                     std::string const& source, Remedy const& remedy) {
  double const shown = limit > 0 ? limit : comfort;
  judge({quantity, value, shown, value / shown, "", source, "", {}}, value >= comfort,
        value >= limit, remedy);
}

void Sheet::judge(Row row, bool ok, bool bearable, Remedy const& remedy) {
  row.verdict = ok ? "ok" : bearable ? "warn" : "bad";
  if (!ok) {
    row.key = remedy.key;
    row.works = remedy.works;
  }
  if (row.margin && std::isinf(*row.margin)) {
    row.margin.reset();
  }
  rows_.push_back(std::move(row));
}

bool Sheet::any_bad() const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [](Row const& row) { return row.verdict == "bad"; });
}

}  // namespace slidewave::preflight
