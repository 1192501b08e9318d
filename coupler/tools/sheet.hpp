// The table that the pre-flight check fills, and the one way in which rows are judged.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "facts.hpp"

namespace slidewave::preflight {

struct Row {
  std::string quantity;  ///< with its unit in brackets
  std::optional<double> value;
  std::optional<double> limit;
  /// How far the value may grow (or fall) to reach the limit: > 1 is inside it.
  std::optional<double> margin;
  std::string verdict = "note";  ///< ok, warn, bad; note: for the reader, or left out
  std::string source;            ///< of the limit; for a left-out row, the reason
  std::string key;               ///< of case.toml to change
  std::optional<double> works;   ///< a value of that key that works
};

/// What to do about a row that is not ok.
struct Remedy {
  std::string key;
  std::optional<double> works;
};

class Sheet {
 public:
  /// True where all facts are there; else adds the row as left out, naming those that are not.
  bool needs(Facts const& facts, std::string const& quantity,
             std::vector<std::string> const& names);
  void left_out(std::string const& quantity, std::string const& reason);
  void note(std::string const& quantity, double value, std::string const& source);
  /// ok up to `comfort`, warn up to `limit`, bad above. An infinite limit never is bad.
  void at_most(std::string const& quantity, double value, double comfort, double limit,
               std::string const& source, Remedy const& remedy);
  /// ok from `comfort` on, warn from `limit` on, bad below. A limit of 0 never is bad.
  void at_least(std::string const& quantity, double value, double comfort, double limit,
                std::string const& source, Remedy const& remedy);

  std::vector<Row> const& rows() const { return rows_; }
  /// The longest window [s] at which every row that the window decides is ok; infinite where none
  /// does.
  double longest_window_s() const { return longest_window_s_; }
  bool any_bad() const;

 private:
  void judge(Row row, bool ok, bool bearable, Remedy const& remedy);
  std::vector<Row> rows_;
  double longest_window_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace slidewave::preflight
