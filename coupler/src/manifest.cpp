#include "manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "durable.hpp"

namespace slidewave {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string Manifest::piece_name(bool fluid, int rank) {
  return fmt::format("{}.{}", fluid ? "fluid" : "dem", rank);
}

fs::path Manifest::folder(fs::path const& run_directory) {
  return run_directory / "checkpoints";
}

fs::path Manifest::folder(fs::path const& run_directory, long window) {
  return folder(run_directory) / fmt::format("{:08d}", window);
}

std::vector<long> Manifest::windows(fs::path const& run_directory) {
  std::vector<long> found;
  std::error_code none;
  for (auto const& entry : fs::directory_iterator(folder(run_directory), none)) {
    std::string const name = entry.path().filename().string();
    bool const number = !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
    if (number && fs::exists(entry.path() / "manifest.json")) {
      found.push_back(std::stol(name));
    }
  }
  std::sort(found.rbegin(), found.rend());
  return found;
}

void Manifest::write(fs::path const& run_directory) const {
  Json json = {{"window", window},           {"time_s", time_s},
               {"window_s", window_s},       {"version", version},
               {"fingerprint", fingerprint}, {"fluid_ranks", fluid_ranks},
               {"dem_ranks", dem_ranks},     {"history_bytes", history_bytes},
               {"wall_s", spent.wall_s},     {"restarts", spent.restarts},
               {"fluid_s", spent.fluid_s},   {"dem_s", spent.dem_s},
               {"pieces", Json::array()}};
  for (int k = 0; k < static_cast<int>(pieces.size()); ++k) {
    bool const fluid = k < fluid_ranks;
    auto const& piece = pieces[static_cast<std::size_t>(k)];
    json["pieces"].push_back({{"file", piece_name(fluid, fluid ? k : k - fluid_ranks)},
                              {"bytes", piece.bytes},
                              {"checksum", fmt::format("{:016x}", piece.checksum)}});
  }
  write_at_once(file(run_directory, window), json.dump(1) + "\n");
}

Manifest Manifest::read(fs::path const& run_directory, long window) {
  try {
    std::ifstream in(file(run_directory, window));
    Json const json = Json::parse(in);
    Manifest manifest;
    manifest.window = json.at("window");
    manifest.time_s = json.at("time_s");
    manifest.window_s = json.at("window_s");
    manifest.version = json.at("version");
    manifest.fingerprint = json.at("fingerprint");
    manifest.fluid_ranks = json.at("fluid_ranks");
    manifest.dem_ranks = json.at("dem_ranks");
    manifest.history_bytes = json.at("history_bytes");
    manifest.spent.wall_s = json.at("wall_s");
    manifest.spent.restarts = json.at("restarts");
    json.at("fluid_s").get_to(manifest.spent.fluid_s);
    json.at("dem_s").get_to(manifest.spent.dem_s);
    for (Json const& piece : json.at("pieces")) {
      manifest.pieces.push_back(
          {piece.at("bytes"), std::stoull(piece.at("checksum").get<std::string>(), nullptr, 16)});
    }
    if (manifest.window != window ||
        static_cast<int>(manifest.pieces.size()) != manifest.fluid_ranks + manifest.dem_ranks) {
      throw std::runtime_error("it belongs to another checkpoint");
    }
    return manifest;
  } catch (std::exception const& error) {
    throw std::runtime_error(std::string("manifest.json is damaged: ") + error.what());
  }
}

std::string Manifest::fault(fs::path const& run_directory) const {
  std::error_code none;
  for (int k = 0; k < static_cast<int>(pieces.size()); ++k) {
    std::string const name = piece_name(k < fluid_ranks, k < fluid_ranks ? k : k - fluid_ranks);
    auto const bytes = fs::file_size(folder(run_directory, window) / name, none);
    if (none) {
      return name + " is missing";
    }
    if (static_cast<long>(bytes) != pieces[static_cast<std::size_t>(k)].bytes) {
      return fmt::format("{} has {} bytes instead of {}", name, bytes,
                         pieces[static_cast<std::size_t>(k)].bytes);
    }
  }
  auto const rows = fs::file_size(run_directory / "history.csv", none);
  if (none || static_cast<long>(rows) < history_bytes) {
    return "history.csv is shorter than it was";
  }
  return "";
}

}  // namespace slidewave
