#include "handshake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace slidewave {
namespace {

using Json = nlohmann::json;

Json write(Session::Impl& session, Hello const& mine, Models const& models) {
  Json hello;
  auto facts = session.facts;
  facts.insert(facts.begin(), {{"slidewave", version()},
                               {"case.toml", session.scene.fingerprint()},
                               {"layout", Layout::of(models).text()}});
  for (Fact const& fact : facts) {
    hello["facts"].push_back({fact.name, fact.value});
  }
  hello["offers"] = Json::array();
  for (Field const& field : mine.offers) {
    hello["offers"].push_back({field.name, field.unit, field.components});
  }
  hello["features"] = Json::array();
  for (Feature const& feature : mine.features) {
    hello["features"].push_back({feature.name, feature.active, feature.reason});
  }
  auto const& box = mine.bounds;
  hello["boxes"] = session.agreement.gather_on_side(
      {box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]},
      "bounds of this side");
  return hello;
}

std::vector<Fact> facts_of(Json const& hello) {
  std::vector<Fact> facts;
  for (Json const& fact : hello["facts"]) {
    facts.push_back({fact[0], fact[1]});
  }
  return facts;
}

std::vector<Field> offers_of(Json const& hello) {
  std::vector<Field> fields;
  for (Json const& field : hello["offers"]) {
    fields.push_back({field[0], field[1], field[2]});
  }
  return fields;
}

void add_features(Json const& hello, std::vector<Feature>& features) {
  for (Json const& feature : hello["features"]) {
    features.push_back({feature[0], feature[1], feature[2]});
  }
}

std::vector<Box> boxes_of(Json const& hello) {
  std::vector<double> const numbers = hello["boxes"];
  std::vector<Box> boxes;
  for (std::size_t k = 0; k + 6 <= numbers.size(); k += 6) {
    boxes.push_back({Vec3(&numbers[k]), Vec3(&numbers[k + 3])});
  }
  return boxes;
}

Vec3 solved_axes(std::string const& boundary) {
  Vec3 axes = Vec3::Ones();
  for (std::size_t k = 0; k < 3 && k < boundary.size(); ++k) {
    axes[static_cast<int>(k)] = boundary[k] == 'e' ? 0 : 1;
  }
  return axes;
}

// The stiff regime foresees one response a grain, for all axes.
void check_held(std::vector<Fact> const& dem, Vec3 const& in_plane) {
  for (char const axis : value_of(dem, "partly_held")) {
    if (in_plane[axis - 'x'] != 0) {
      throw InputError("case.toml", "coupling.regime", "stiff",
                       fmt::format("particles are held along {} and free along other axes (fix "
                                   "setforce with NULL?), which the stiff regime cannot foresee: "
                                   "hold them wholly or not at all, or take \"mild\"",
                                   axis));
    }
  }
}

// Every particle finds its alpha in the list.
void check_types(std::vector<Fact> const& dem, Models const& models) {
  std::string const types = value_of(dem, "particle_types");
  if (models.by_type() && types != std::to_string(models.coarse_grain_by_type.size())) {
    throw InputError("case.toml", "models.coarse_grain_by_type",
                     fmt::format("{} numbers", models.coarse_grain_by_type.size()),
                     fmt::format("the particle script has {} types: give a number each",
                                 types.empty() ? "no" : types));
  }
}

}  // namespace

void check_needs(Models const& models, std::vector<Field> const& offers) {
  for (Need const& need : models.needs()) {
    Field const* offered = nullptr;
    for (Field const& field : offers) {
      offered = field.name == need.field.name ? &field : offered;
    }
    if (!offered) {
      throw std::runtime_error(
          fmt::format("the model '{}' needs the field '{}' [{}], which the fluid engine does not "
                      "offer; switch the model off ({}) or use another engine",
                      need.model, need.field.name, need.field.unit, need.key));
    }
    if (offered->unit != need.field.unit || offered->components != need.field.components) {
      throw std::runtime_error(fmt::format(
          "the model '{}' needs the field '{}' as {} x [{}], the fluid engine offers {} x [{}]",
          need.model, need.field.name, need.field.components, need.field.unit, offered->components,
          offered->unit));
    }
  }
}

void check_particle_needs(Models const& models, ParticleEngine const& engine) {
  auto const check = [](std::vector<Need> const& needs, std::vector<std::string> const& offers,
                        char const* does) {
    for (Need const& need : needs) {
      if (std::find(offers.begin(), offers.end(), need.field.name) == offers.end()) {
        throw InputError("case.toml", need.key, need.model,
                         fmt::format("needs the column '{}' [{}], which this particle engine does "
                                     "not {}; switch the model off or use another engine",
                                     need.field.name, need.field.unit, does));
      }
    }
  };
  check(models.particle_needs(), engine.extras(), "gather");
  check(models.answer_needs(), engine.takes(), "take");
}

Agreed handshake(Session::Impl& session, Hello const& mine) {
  Agreed agreed;
  if (session.world.has_partner()) {
    agreed.models = Models::from(session.scene);
  } else {
    agreed.models = Models::none();
  }
  Json ours = write(session, mine, agreed.models);
  Json theirs = ours;
  if (session.world.has_partner()) {
    std::string text = ours.dump();
    std::string answer;
    if (session.is_root()) {
      answer = session.agreement.swap_between_roots(text, "its hello (is it still setting up?)");
    }
    session.agreement.share_on_side(text, "the first rank's hello");
    session.agreement.share_on_side(answer, "the partner's hello");
    ours = Json::parse(text);
    theirs = Json::parse(answer);
  }
  bool const is_fluid = session.role == Role::fluid;
  Json const& fluid = is_fluid ? ours : theirs;
  Json const& dem = is_fluid ? theirs : ours;
  std::string const differences = mismatches(facts_of(fluid), facts_of(dem));
  if (!differences.empty()) {
    session.failure.fail("the two sides disagree, nothing was started:" + differences, 2);
  }
  agreed.layout = Layout::of(agreed.models);
  agreed.features = agreed.models.features();
  if (session.world.has_partner()) {
    std::vector<Field> const offers = offers_of(fluid);
    try {
      check_needs(agreed.models, offers);
    } catch (std::runtime_error const& error) {
      session.failure.fail(error.what(), 2);
    }
    for (Field const& field : offers) {
      agreed.saturation = agreed.saturation || field.name == "saturation";
    }
    agreed.in_plane = solved_axes(value_of(facts_of(fluid), "boundary"));
    if (agreed.models.stiff) {
      check_held(facts_of(dem), agreed.in_plane);
    }
    check_types(facts_of(dem), agreed.models);
    agreed.fluid_boxes = boxes_of(fluid);
    add_features(fluid, agreed.features);
    add_features(dem, agreed.features);
  } else {
    agreed.features = {{"coupling", false, "one side only"}};
    add_features(ours, agreed.features);
  }
  return agreed;
}

std::string describe(Agreed const& agreed) {
  std::string text = "slidewave " + version();
  for (bool active : {true, false}) {
    text += active ? "\nactive" : "\nleft out";
    for (Feature const& feature : agreed.features) {
      if (feature.active == active) {
        text += fmt::format("\n  {:<30} {}", feature.name, feature.reason);
      }
    }
  }
  if (!agreed.fluid_boxes.empty()) {
    text += "\nper particle and window\n" + agreed.layout.text();
  }
  return text;
}

}  // namespace slidewave
