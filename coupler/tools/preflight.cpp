// slidewave_preflight [DIR | case.toml] [--facts FILE.json] [--json]
//
// Every stability and accuracy number of a scene against its limit, before a core-hour is spent.
// The numbers come from the case and from a file of facts (facts.hpp has their names); without
// either, facts are read from standard input and rows go out as JSON.
// Exit status: 0 nothing bad, 1 something is bad, 2 bad input.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>

#include "checks.hpp"
#include "print.hpp"

namespace slidewave::preflight {
namespace {

struct Options {
  std::filesystem::path directory;
  std::filesystem::path facts;
  bool json = false;
  bool piped() const { return directory.empty() && facts.empty(); }
};

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    std::string const word = argv[i];
    if (word == "--json") {
      options.json = true;
    } else if (word == "--facts" && i + 1 < argc) {
      options.facts = argv[++i];
    } else if (word.rfind("--", 0) == 0) {
      throw InputError("command line", word, "",
                       "is unknown or lacks its value; "
                       "use slidewave_preflight [DIR] [--facts FILE] [--json]");
    } else {
      std::filesystem::path const path = std::filesystem::absolute(word);
      options.directory = path.extension() == ".toml" ? path.parent_path() : path;
    }
  }
  return options;
}

nlohmann::json read_facts(std::istream& stream, std::string const& name) {
  try {
    auto facts = nlohmann::json::parse(stream);
    if (facts.is_object()) {
      return facts;
    }
  } catch (nlohmann::json::parse_error const& error) {
    throw InputError(name, "(file)", "", error.what());
  }
  throw InputError(name, "(file)", "", "must be one JSON object");
}

Facts gather(Options const& options) {
  nlohmann::json given = nlohmann::json::object();
  if (!options.facts.empty()) {
    std::ifstream stream(options.facts);
    if (!stream) {
      throw InputError(options.facts.string(), "(file)", "", "cannot be read");
    }
    given = read_facts(stream, options.facts.string());
  } else if (options.piped()) {
    given = read_facts(std::cin, "standard input");
  }
  Facts facts(given);
  if (!options.directory.empty()) {
    add_case(Scene(options.directory), facts);
  }
  return facts;
}

int examine(Options const& options) {
  Facts const facts = gather(options);
  Sheet sheet;
  check_particles(facts, sheet);
  check_coupling(facts, sheet);
  check_fluid(facts, sheet);
  check_cost(facts, sheet);
  check_names(facts, sheet);
  if (options.json || options.piped()) {
    std::cout << as_json(sheet).dump(1) << "\n";
  } else {
    std::cout << as_table(sheet);
  }
  return sheet.any_bad() ? 1 : 0;
}

}  // namespace
}  // namespace slidewave::preflight

int main(int argc, char** argv) {
  try {
    return slidewave::preflight::examine(slidewave::preflight::parse(argc, argv));
  } catch (std::exception const& error) {
    std::cerr << "slidewave_preflight: " << error.what() << "\n";
    return 2;
  }
}
