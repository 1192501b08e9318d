#include "slidewave/table.hpp"

#include <stdexcept>
#include <utility>

namespace slidewave {

void Table::add(Field const& field) {
  Data& data = columns_[field.name];
  data.field = field;
  data.values.clear();
}

void Table::resize(long particles) {
  size_ = particles;
  for (auto& [name, data] : columns_) {
    data.lent = nullptr;
  }
}

Table::Data const& Table::find(std::string_view name) const {
  auto const found = columns_.find(name);
  if (found == columns_.end()) {
    throw std::out_of_range("slidewave: no column '" + std::string(name) + "' was negotiated");
  }
  return found->second;
}

void Table::lend(std::string_view name, double* values) {
  Data& data = columns_.at(find(name).field.name);
  if (!data.is_lent) {
    data.values = {};
  }
  data.is_lent = true;
  data.lent = values;
}

Table::Column Table::operator[](std::string_view name) {
  ConstColumn const column = std::as_const(*this)[name];
  return {const_cast<double*>(column.data()), column.rows(), column.cols()};
}

Table::ConstColumn Table::operator[](std::string_view name) const {
  Data const& data = find(name);
  if (!data.is_lent) {  // made when it is wanted: those that are going to be lent never are
    data.values.resize(static_cast<std::size_t>(size_) * data.field.components, 0.0);
    return {data.values.data(), data.field.components, size_};
  }
  if (!data.lent && size_ > 0) {
    throw std::logic_error("slidewave: column '" + data.field.name +
                           "' was lent, but not again after the table's size changed");
  }
  return {data.lent, data.field.components, size_};
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
