// The archive for visit_checkpoint that checks each value against its field.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "geometry/decimal.hpp"
#include "model/model.hpp"
#include "output/checkpoint/checkpoint_expectations.hpp"

namespace blocks::output {

/// Throws hdf5::Failure, such as "blocks/mass: value 3 is -1, expected a number above
/// 0", if a value is not in the range of its field, an index refers to nothing, or a
/// column has another number of rows. The rows of the blocks of the model must be in
/// order, because they tell how many blocks and corners there are.
class ExpectingArchive {
 public:
  explicit ExpectingArchive(const Model& model) : model_(model) {}

  template <Number T> void operator()(const Field& field, const T& value) {
    expect(field, value);
  }
  void operator()(const Field&, const std::string&) {}
  void operator()(const Field& field, const geometry::Decimal& number) {
    expect(field, number.value());
  }
  template <class T>
  void operator()(const Field& field, const std::optional<T>& value) {
    if (value)
      (*this)(field, *value);
  }
  void operator()(const Field&, const std::vector<std::string>&) {}
  template <Number T>
  void operator()(const Field& field, const std::vector<T>& column) {
    expect_rows(field, static_cast<long>(column.size()));
    for (std::size_t i = 0; i < column.size(); ++i)
      expect(field, column[i], i + 1);
  }
  template <class Derived>
  void operator()(const Field& field, const Eigen::PlainObjectBase<Derived>& values) {
    constexpr bool is_point = Derived::SizeAtCompileTime != Eigen::Dynamic;
    constexpr bool is_matrix = Derived::ColsAtCompileTime != 1;
    if (!is_point)
      expect_rows(field, is_matrix ? values.cols() : values.size());
    const Eigen::Index width = is_matrix ? values.rows() : 1;
    for (Eigen::Index i = 0; i < values.size(); ++i)
      expect(field, values.data()[i],
             is_point ? 0 : static_cast<std::size_t>(i / width + 1));
  }
  template <class Record, class Visit>
  void records(const Field& list, const std::vector<Record>& records, Visit&& visit) {
    Columns columns{*this, list};
    for (const Record& record : records) {
      ++columns.row;
      visit(columns, record);
    }
  }
  template <class Map, class Visit>
  void materials(const Field& list, const Map& map, Visit&& visit) {
    Columns columns{*this, list};
    for (const auto& [key, value] : map) {
      ++columns.row;
      visit(columns, key, value);
    }
  }

 private:
  struct Columns {
    const ExpectingArchive& archive;
    const Field& list;
    std::size_t row = 0;
    template <Number T> void operator()(Field field, const T& member) const {
      if (field.range.words == nullptr)
        field.range = list.range;
      archive.expect(field, member, row, list.name);
    }
    void operator()(const Field&, const std::string&) const {}
  };

  /// Expects a value, which is in a row (from 1; 0: it is the only one) of a list.
  template <Number T>
  void expect(const Field& field, T value, std::size_t row = 0,
              const char* list = nullptr) const {
    const auto number = static_cast<double>(value);
    const Range& range = field.range.words != nullptr ? field.range : finite;
    const bool is_index = field.index != IndexOf::nothing;
    const bool holds = is_index ? refers(field.index, number) : range.holds(number);
    if (holds)
      return;
    std::string what =
        list == nullptr ? field.name : fmt::format("{}/{}", list, field.name);
    if (row > 0)
      what += fmt::format(": value {}", row);
    if (is_index)
      reject_checkpoint(fmt::format("{} names number {} of {}", what, number + 1.0,
                                    count(field.index)));
    reject_checkpoint(fmt::format("{} is {}, expected {}", what, number, range.words));
  }

  long count(IndexOf kind) const {
    switch (kind) {
    case IndexOf::block:
    case IndexOf::block_or_none:
      return model_.blocks.size();
    case IndexOf::corner:
      return model_.blocks.corners();
    case IndexOf::plane:
      return std::ssize(model_.settings.planes);
    case IndexOf::safety_factor:
      return std::ssize(model_.safety_factors);
    case IndexOf::nothing:
      break;
    }
    return 0;
  }
  bool refers(IndexOf kind, double index) const {
    return index >= (kind == IndexOf::block_or_none ? -1.0 : 0.0) &&
           index < static_cast<double>(count(kind));
  }
  void expect_rows(const Field& field, long rows) const {
    const long expected =
        field.rows == Rows::per_corner ? model_.blocks.corners() : model_.blocks.size();
    if (field.rows == Rows::any ||
        (field.rows == Rows::per_block_or_none && rows == 0) || rows == expected)
      return;
    reject_checkpoint(
        fmt::format("{} has {} rows, expected {}", field.name, rows, expected));
  }

  const Model& model_;
};

}  // namespace blocks::output
