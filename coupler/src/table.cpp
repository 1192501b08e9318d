#include "slidewave/table.hpp"

#include <stdexcept>

namespace slidewave {

void Table::add(Field const& field) {
  Data& data = columns_[field.name];
  data.field = field;
  data.values.assign(static_cast<std::size_t>(size_) * field.components, 0.0);
}

void Table::resize(long particles) {
  size_ = particles;
  for (auto& [name, data] : columns_) {
    data.values.resize(static_cast<std::size_t>(particles) * data.field.components, 0.0);
  }
}

Table::Column Table::operator[](std::string_view name) {
  auto const found = columns_.find(name);
  if (found == columns_.end()) {
    throw std::out_of_range("slidewave: no column '" + std::string(name) + "' was negotiated");
  }
  return {found->second.values.data(), found->second.field.components, size_};
}

Table::ConstColumn Table::operator[](std::string_view name) const {
  auto const found = columns_.find(name);
  if (found == columns_.end()) {
    throw std::out_of_range("slidewave: no column '" + std::string(name) + "' was negotiated");
  }
  return {found->second.values.data(), found->second.field.components, size_};
}

std::vector<Field> Table::fields() const {
  std::vector<Field> fields;
  for (auto const& [name, data] : columns_) {
    fields.push_back(data.field);
  }
  return fields;
}

long Table::bytes_per_particle() const {
  long bytes = 0;
  for (auto const& [name, data] : columns_) {
    bytes += data.field.components * static_cast<long>(sizeof(double));
  }
  return bytes;
}

}  // namespace slidewave
