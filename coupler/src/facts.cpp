#include "facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace slidewave {
namespace {

std::vector<std::string> words(std::string text) {
  for (char& letter : text) {
    if (std::string("()[],;").find(letter) != std::string::npos) {
      letter = ' ';
    }
  }
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

std::optional<double> number(std::string const& word) {
  char* end = nullptr;
  double const value = std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size() ? std::optional(value) : std::nullopt;
}

bool words_agree(std::string const& one, std::string const& two) {
  auto const a = number(one);
  auto const b = number(two);
  if (!a || !b) {
    return one == two;
  }
  return *a == *b || std::abs(*a - *b) <= 1e-9 * std::max(std::abs(*a), std::abs(*b));
}

bool axes_agree(std::string const& one, std::string const& two) {
  return one.size() == two.size() &&
         std::equal(one.begin(), one.end(), two.begin(),
                    [](char a, char b) { return a == b || a == 'e' || b == 'e'; });
}

}  // namespace

bool agree(std::string const& name, std::string const& one, std::string const& two) {
  if (name == "boundary") {
    return axes_agree(one, two);
  }
  auto const a = words(one);
  auto const b = words(two);
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), words_agree);
}

std::string value_of(std::vector<Fact> const& facts, std::string const& name) {
  auto const found =
      std::find_if(facts.begin(), facts.end(), [&](Fact const& fact) { return fact.name == name; });
  return found == facts.end() ? "" : found->value;
}

std::string mismatches(std::vector<Fact> const& fluid, std::vector<Fact> const& dem) {
  std::string rows;
  for (Fact const& fact : fluid) {
    std::string const theirs = value_of(dem, fact.name);
    if (!theirs.empty() && !agree(fact.name, fact.value, theirs)) {
      rows += fmt::format("\n  {:<20} {:<28} {}", fact.name, fact.value, theirs);
    }
  }
  return rows.empty() ? "" : fmt::format("\n  {:<20} {:<28} {}", "fact", "fluid", "dem") + rows;
}

}  // namespace slidewave
