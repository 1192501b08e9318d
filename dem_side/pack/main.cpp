// slidewave_pack: fills the space between a failure surface and the ground with spheres.
//
//   slidewave_pack fill --base F --top F --width m --least m --most m --out F [options]
//   slidewave_pack trim --dump F --base F --top F --width m --gap m --out F [options]
//   slidewave_pack convert --dump F --base F --top F --width m --out F [options]
//
// fill: random points, then overlap removal. trim: keeps of a settled dump what lies below the
// ground and at least `gap` before the toe. convert: keeps everything. Each writes a LIGGGHTS data
// file (at rest) and one JSON line.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

#include "data_file.hpp"
#include "spheres.hpp"

namespace {

using namespace slidewave::pack;

class Options {
 public:
  Options(int argc, char** argv) {
    for (int i = 2; i < argc; i += 2) {
      std::string const key = argv[i];
      if (key.rfind("--", 0) != 0 || i + 1 >= argc) {
        throw std::invalid_argument("expected '--option value' at '" + key + "'");
      }
      values_[key.substr(2)] = argv[i + 1];
    }
  }
  std::string text(std::string const& name) {
    auto const found = values_.find(name);
    if (found == values_.end()) throw std::invalid_argument("--" + name + " is missing");
    auto value = found->second;
    values_.erase(found);
    return value;
  }
  double number(std::string const& name) {
    auto const value = text(name);
    std::size_t used = 0;
    double const result = std::stod(value, &used);
    if (used != value.size()) throw std::invalid_argument("--" + name + ": not a number: " + value);
    return result;
  }
  double number(std::string const& name, double otherwise) {
    return values_.count(name) ? number(name) : otherwise;
  }
  /// Refuses what no one asked for.
  void done() const {
    if (!values_.empty()) throw std::invalid_argument("unknown option --" + values_.begin()->first);
  }

 private:
  std::map<std::string, std::string> values_;
};

Bounds read_bounds(Options& options, Room const& room) {
  auto const& base = room.base.points();
  double low = base.front().z;
  double high = room.top.points().front().z;
  for (auto const& p : base) low = std::min(low, p.z);
  return {
      {options.number("xlo", base.front().x - 50), 0, options.number("zlo", low - 50)},
      {options.number("xhi", base.back().x + 50), room.width, options.number("zhi", high + 100)}};
}

void report(Room const& room, std::vector<Sphere> const& spheres) {
  auto const overlap = measure_overlap(room, spheres);
  std::printf(
      "{\"particles\": %zu, \"solid_fraction\": %.6g, \"largest_overlap\": %.3g, "
      "\"mean_overlap\": %.3g}\n",
      spheres.size(), solid_fraction(room, spheres), overlap.largest, overlap.mean);
}

int fill(Options& options) {
  Room room{Polyline::read(options.text("base")), Polyline::read(options.text("top")),
            options.number("width"), 0};
  Diameters const diameters{options.number("least"), options.number("most")};
  if (diameters.least <= 0 || diameters.most < diameters.least) {
    throw std::invalid_argument("--least and --most must be positive and in this order");
  }
  if (room.width <= diameters.most) {
    throw std::invalid_argument("--width must be above --most: a sphere would touch itself");
  }
  room.margin = options.number("margin", diameters.most);
  double const wanted = options.number("solid_fraction", 0.59);
  auto const passes = static_cast<int>(options.number("passes", 300));
  double const limit = options.number("limit", 0.02);
  auto const seed = static_cast<std::uint64_t>(options.number("seed", 1));
  double const density = options.number("density", 2650);
  auto const types = static_cast<int>(options.number("types", 1));
  auto const bounds = read_bounds(options, room);
  auto const out = options.text("out");
  options.done();
  auto spheres = scatter(room, diameters, wanted, seed);
  for (int pass = 0; pass < passes; ++pass) separate(room, spheres);
  drop_crowded(room, spheres, limit);
  write_data(out, spheres, bounds, density, types);
  report(room, spheres);
  return 0;
}

int from_dump(Options& options, bool trimmed) {
  Room room{Polyline::read(options.text("base")), Polyline::read(options.text("top")),
            options.number("width"), 0};
  auto const dump = options.text("dump");
  double const gap = trimmed ? options.number("gap") : 0;
  double const density = options.number("density", 2650);
  auto const types = static_cast<int>(options.number("types", 1));
  auto const bounds = read_bounds(options, room);
  auto const out = options.text("out");
  options.done();
  auto spheres = read_dump(dump);
  if (trimmed) spheres = trim(room, spheres, gap);
  write_data(out, spheres, bounds, density, types);
  report(room, spheres);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string const command = argc > 1 ? argv[1] : "";
  try {
    Options options(argc, argv);
    if (command == "fill") return fill(options);
    if (command == "trim" || command == "convert") return from_dump(options, command == "trim");
    throw std::invalid_argument("expected fill, trim or convert, got '" + command + "'");
  } catch (std::invalid_argument const& error) {
    std::fprintf(stderr, "slidewave_pack: %s\n", error.what());
    return 2;
  } catch (std::exception const& error) {
    std::fprintf(stderr, "slidewave_pack: %s\n", error.what());
    return 1;
  }
}
