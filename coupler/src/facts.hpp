// Facts that both sides state and that must agree.
#pragma once

#include <string>
#include <vector>

namespace slidewave {

struct Fact {
  std::string name;
  std::string value;
};

/// Numbers within 1e-9 relative, word by word; "boundary" (one letter an axis: p periodic, b
/// bounded, e empty) letter by letter, where e agrees with both others.
bool agree(std::string const& name, std::string const& one, std::string const& two);

/// A table of what differs, one row each with both values; empty where all agree. A fact that only
/// one side states is no mismatch.
std::string mismatches(std::vector<Fact> const& fluid, std::vector<Fact> const& dem);

/// The value of a fact, or empty.
std::string value_of(std::vector<Fact> const& facts, std::string const& name);

}  // namespace slidewave
