#include "layout.hpp"

#include <fmt/format.h>

#include "contact_memory.hpp"

namespace slidewave {
namespace {

constexpr long owners = 2097152;  // 2^21 ranks x 2^31 cells fit the 53 bits of a double

std::string list(std::vector<Field> const& fields) {
  std::string text;
  for (Field const& field : fields) {
    text += fmt::format("{}{}[{}]", text.empty() ? "" : " ", field.name, field.components);
  }
  return text;
}

/// Ledger and home, and in the stiff regime what the contacts did.
Field memory_of(Models const& models) {
  return {"memory", "-", 4 + (models.stiff ? contact_memory : 0)};
}

}  // namespace

Layout Layout::of(Models const& models) {
  Layout layout;
  layout.to_fluid = {{"position", "m", 3}, {"radius", "m", 1}, {"cell_hint", "-", 1}};
  layout.to_dem = {{"cell", "-", 1}};
  if (models.drag || models.lift) {
    layout.to_fluid.push_back({"velocity", "m/s", 3});
  }
  if (models.by_type()) {
    layout.to_fluid.push_back({"type", "-", 1});
  }
  if (models.drag) {
    layout.to_dem.push_back({"drag", "kg/s", 1});
    layout.to_dem.push_back({"fluid_velocity", "m/s", 3});
  }
  if (models.force()) {
    layout.to_dem.push_back({"force", "N", 3});
  }
  for (Need const& need : models.answer_needs()) {
    layout.to_dem.push_back(need.field);
  }
  if (models.ledger()) {
    layout.to_fluid.push_back({"ledger", "kg m/s", 3});
    layout.to_dem.push_back({"given", "kg m/s", 3});
  }
  if (models.stiff) {
    for (Field const& field : {Field{"mass", "kg", 1}, Field{"other_force", "N", 3},
                               Field{"stiffness", "N/m", 1}, Field{"solid_velocity", "m/s", 3}}) {
      layout.to_fluid.push_back(field);
    }
  }
  return layout;
}

std::vector<Field> Layout::gathered(Models const& models, bool has_partner) {
  std::vector<Field> fields = {{"position", "m", 3}, {"radius", "m", 1}, {"mass", "kg", 1}};
  if (has_partner) {
    fields.push_back(memory_of(models));
    for (Need const& need : models.particle_needs()) {
      fields.push_back(need.field);
    }
    if (models.drag || models.lift) {
      fields.push_back({"velocity", "m/s", 3});
    }
    if (models.ledger()) {
      fields.push_back({"impulse", "kg m/s", 3});
    }
  }
  return fields;
}

std::vector<Field> Layout::answered(Models const& models) {
  std::vector<Field> fields = {memory_of(models)};
  if (models.drag) {
    fields.push_back({"drag", "kg/s", 1});
    fields.push_back({"fluid_velocity", "m/s", 3});
  }
  if (models.force()) {
    fields.push_back({"force", "N", 3});
  }
  for (Need const& need : models.answer_needs()) {
    fields.push_back(need.field);
  }
  return fields;
}

std::string Layout::text() const {
  return fmt::format("  to fluid {} B: {}\n  to dem {} B: {}", 8 * doubles_per_particle(to_fluid),
                     list(to_fluid), 8 * doubles_per_particle(to_dem), list(to_dem));
}

int doubles_per_particle(std::vector<Field> const& fields) {
  int count = 0;
  for (Field const& field : fields) {
    count += field.components;
  }
  return count;
}

HomeCode HomeCode::decode(double code) {
  long const whole = static_cast<long>(code);
  return {static_cast<int>(whole % owners) - 1, static_cast<int>(whole / owners) - 1};
}

double HomeCode::encode() const {
  return static_cast<double>(owner + 1 + owners * (cell + 1L));
}

}  // namespace slidewave
