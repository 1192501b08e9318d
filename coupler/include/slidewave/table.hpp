// A table of particles: one row each, one column per negotiated field.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace slidewave {

using Vec3 = Eigen::Vector3d;

/// One quantity per particle: its name, SI unit and number of components (1 or 3).
struct Field {
  std::string name;
  std::string unit;
  int components = 1;
};

/// Columns of equal length. A column is a matrix of components x size(), particle i in column i,
/// contiguous per particle. Only fields that were added take memory.
class Table {
 public:
  using Column = Eigen::Map<Eigen::MatrixXd>;
  using ConstColumn = Eigen::Map<Eigen::MatrixXd const>;

  void add(Field const& field);
  bool has(std::string_view name) const { return columns_.find(name) != columns_.end(); }
  long size() const { return size_; }
  /// Changes the number of particles; values of rows that stay are kept, new rows hold anything.
  void resize(long particles);
  /// Uses `values` (components x size(), contiguous per particle) as the column instead of memory
  /// of its own: what is read and written is there. Ends with the next resize(): to be lent again
  /// then.
  void lend(std::string_view name, double* values);
  /// Throws std::out_of_range, naming the field, where it was not added.
  Column operator[](std::string_view name);
  ConstColumn operator[](std::string_view name) const;
  std::vector<Field> fields() const;
  long bytes_per_particle() const;

 private:
  struct Data {
    Field field;
    mutable std::vector<double> values;  ///< as long as they were when last looked at
    bool is_lent = false;
    double* lent = nullptr;
  };
  Data const& find(std::string_view name) const;
  std::map<std::string, Data, std::less<>> columns_;
  long size_ = 0;
};

}  // namespace slidewave
