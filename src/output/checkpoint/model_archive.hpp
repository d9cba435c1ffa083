// Two archives for visit_model: one writes fields as datasets of a file, the other
// restores them bit for bit. Integers are stored with 64 bits.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "files/hdf5_handle.hpp"
#include "output/checkpoint/model_fields.hpp"

namespace blocks::output {

template <class T>
using Stored = std::conditional_t<std::is_floating_point_v<T>, double, std::int64_t>;

template <class T> Stored<T> to_stored(T value) {
  if constexpr (std::is_enum_v<T>)
    return static_cast<std::int64_t>(value);
  else
    return static_cast<Stored<T>>(value);
}

/// Throws Failure if the value of the dataset `name` does not fit into T, because the
/// file is then invalid.
template <class T> T from_stored(const std::string& name, Stored<T> value) {
  const T result = static_cast<T>(value);
  if constexpr (!std::is_floating_point_v<T>)
    if (to_stored(result) != value)
      throw hdf5::Failure(name + " has a number out of range");
  return result;
}

/// One member of all structs in a list, as a column.
using RecordColumn = std::variant<std::vector<double>, std::vector<std::int64_t>,
                                  std::vector<std::string>>;

class SavingArchive {
 public:
  explicit SavingArchive(hid_t group) : group_(group) {}

  template <class T> void operator()(const Field& field, const T& value) {
    save(field.name, value);
  }
  template <class Record, class Visit>
  void records(const Field& field, const std::vector<Record>& list, Visit&& visit) {
    save(field.name + std::string("/count"), static_cast<std::int64_t>(list.size()));
    put_members(field.name, list, visit);
  }
  template <class Map, class Visit>
  void materials(const Field& field, const Map& map, Visit&& visit) {
    save(field.name + std::string("/count"), static_cast<std::int64_t>(map.size()));
    put_members(field.name, map, [&](auto& column, const auto& entry) {
      visit(column, entry.first, entry.second);
    });
  }

 private:
  template <Number T> void save(const std::string& name, const T& value) {
    const Stored<T> stored = to_stored(value);
    put(name, &stored, 1, 0);
  }
  void save(const std::string& name, const std::string& text) {
    hdf5::write_text(group_, name, text);
  }
  void save(const std::string& name, const geometry::Decimal& number) {
    hdf5::write_text(group_, name,
                     number.digits() + "e" + std::to_string(number.exponent()));
  }
  template <class T> void save(const std::string& name, const std::optional<T>& value) {
    save(name + "_given", value.has_value());
    if (value)
      save(name, *value);
  }
  /// Writes texts without line breaks as one text, each ended by a line break.
  void save(const std::string& name, const std::vector<std::string>& texts) {
    std::string lines;
    for (const std::string& text : texts)
      lines += text + '\n';
    hdf5::write_text(group_, name, lines);
  }
  template <Number T> void save(const std::string& name, const std::vector<T>& values) {
    put_pieces<Stored<T>>(name, values, [](T value) { return to_stored(value); });
  }
  /// Writes each column of the matrix, such as a block, a corner or a contact, as one
  /// row of the dataset.
  template <class Derived>
  void save(const std::string& name, const Eigen::PlainObjectBase<Derived>& matrix) {
    const bool vector = Derived::ColsAtCompileTime == 1;
    put(name, matrix.data(),
        static_cast<hsize_t>(vector ? matrix.size() : matrix.cols()),
        vector ? 0 : static_cast<hsize_t>(matrix.rows()));
  }

  /// Captures one member of a record and skips the others.
  struct Member {
    std::size_t wanted, passed = 0;
    const char* name = nullptr;  ///< null if there is no member of that index
    std::variant<double, std::int64_t, const std::string*> value = {};
    template <Number T> void operator()(const Field& field, const T& member) {
      if (passed++ == wanted)
        name = field.name, value = to_stored(member);
    }
    void operator()(const Field& field, const std::string& member) {
      if (passed++ == wanted)
        name = field.name, value = &member;
    }
  };

  static constexpr std::size_t rows_at_once = 65536;
  template <class T>
  hdf5::Column make(const std::string& name, hsize_t rows, hsize_t width) {
    const hsize_t chunk = std::clamp<hsize_t>(rows, 1, rows_at_once);
    return {group_, name, hdf5::type_of<T>(), width, chunk, true};
  }
  template <class T>
  void put(const std::string& name, const T* values, hsize_t rows, hsize_t width) {
    make<T>(name, rows, width).put(0, values, rows);
  }
  /// Writes one column per member, one after the other, so that they are never all in
  /// memory.
  template <class List, class Visit>
  void put_members(const std::string& name, const List& list, Visit&& visit) {
    if (list.empty())
      return;
    for (std::size_t wanted = 0;; ++wanted) {
      Member first{wanted};
      visit(first, *list.begin());
      if (first.name == nullptr)
        return;
      const std::string column = name + "/" + first.name;
      std::visit(
          [&]<class T>(T) {
            const auto value = [&](const auto& record) {
              Member member{wanted};
              visit(member, record);
              return std::get<T>(member.value);
            };
            if constexpr (std::is_same_v<T, const std::string*>) {
              std::vector<std::string> texts;
              for (const auto& record : list)
                texts.push_back(*value(record));
              save(column, texts);
            } else {
              put_pieces<T>(column, list, value);
            }
          },
          first.value);
    }
  }
  /// Writes the column of value(item) for all items in pieces, so that the list is
  /// never copied as a whole.
  template <class T, class List, class Value>
  void put_pieces(const std::string& name, const List& list, Value&& value) {
    hdf5::Column column = make<T>(name, list.size(), 0);
    std::vector<T> piece;
    const auto flush = [&] {
      column.put(column.rows(), piece.data(), piece.size());
      piece.clear();
    };
    for (const auto& item : list) {
      piece.push_back(value(item));
      if (piece.size() == rows_at_once)
        flush();
    }
    flush();
  }

  hid_t group_;
};

class LoadingArchive {
 public:
  explicit LoadingArchive(hid_t group) : group_(group) {}

  template <class T> void operator()(const Field& field, T& value) {
    load(field.name, value);
  }
  template <class Record, class Visit>
  void records(const Field& field, std::vector<Record>& list, Visit&& visit) {
    Columns columns{*this, field.name, count(field.name), {}};
    list.clear();
    for (; columns.row < columns.rows; ++columns.row) {
      columns.next = 0;
      visit(columns, list.emplace_back());
    }
  }
  template <class Map, class Visit>
  void materials(const Field& field, Map& map, Visit&& visit) {
    Columns columns{*this, field.name, count(field.name), {}};
    map.clear();
    for (; columns.row < columns.rows; ++columns.row) {
      columns.next = 0;
      typename Map::key_type number{};
      typename Map::mapped_type material;
      visit(columns, number, material);
      map.emplace(number, material);
    }
  }

 private:
  template <Number T> void load(const std::string& name, T& value) {
    const auto stored = get<Stored<T>>(name);
    if (stored.size() != 1)
      throw hdf5::Failure(name + " is not one number");
    value = from_stored<T>(name, stored.front());
  }
  void load(const std::string& name, std::string& text) {
    text = hdf5::read_text(group_, name);
  }
  void load(const std::string& name, geometry::Decimal& number) {
    const auto read = geometry::Decimal::parse(hdf5::read_text(group_, name));
    if (!read)
      throw hdf5::Failure(name + " is not a number");
    number = *read;
  }
  template <class T> void load(const std::string& name, std::optional<T>& value) {
    bool given = false;
    load(name + "_given", given);
    value.reset();
    if (given)
      load(name, value.emplace());
  }
  void load(const std::string& name, std::vector<std::string>& texts) {
    texts.clear();
    std::istringstream lines(hdf5::read_text(group_, name));
    for (std::string line; std::getline(lines, line);)
      texts.push_back(std::move(line));
  }
  template <Number T> void load(const std::string& name, std::vector<T>& values) {
    values.clear();
    for (const auto stored : get<Stored<T>>(name))
      values.push_back(from_stored<T>(name, stored));
  }
  template <class Derived>
  void load(const std::string& name, Eigen::PlainObjectBase<Derived>& matrix) {
    constexpr bool vector = Derived::ColsAtCompileTime == 1;
    hdf5::Column column = hdf5::Column::open(group_, name);
    const auto values = column.read<double>(0, column.rows());
    const auto rows = static_cast<Eigen::Index>(column.rows());
    const bool fits =
        vector ? column.width() == 1 && (Derived::RowsAtCompileTime == Eigen::Dynamic ||
                                         Derived::RowsAtCompileTime == rows)
               : column.width() == Derived::RowsAtCompileTime;
    if (!fits)
      throw hdf5::Failure(name + " has the wrong shape");
    if constexpr (vector)
      matrix.resize(rows);
    else
      matrix.resize(Derived::RowsAtCompileTime, rows);
    std::copy(values.begin(), values.end(), matrix.data());
  }

  struct Columns {
    LoadingArchive& from;
    std::string list;
    std::size_t rows;
    std::vector<RecordColumn> all;
    std::size_t row = 0, next = 0;
    template <Number T> void operator()(const Field& field, T& member) {
      const std::string column = list + "/" + field.name;
      member = from_stored<T>(column, value<Stored<T>>(field.name, [&] {
                                return from.get<Stored<T>>(column);
                              }));
    }
    void operator()(const Field& field, std::string& member) {
      member = value<std::string>(field.name, [&] {
        std::vector<std::string> texts;
        from.load(list + "/" + field.name, texts);
        return texts;
      });
    }
    /// Returns the value of the next column in this row. Reads the column once.
    template <class T, class Read> const T& value(const char* name, Read&& read) {
      if (next == all.size()) {
        std::vector<T> values = read();
        if (values.size() != rows)
          throw hdf5::Failure(list + "/" + name + " has the wrong length");
        all.emplace_back(std::move(values));
      }
      return std::get<std::vector<T>>(all[next++])[row];
    }
  };

  template <class T> std::vector<T> get(const std::string& name) {
    hdf5::Column column = hdf5::Column::open(group_, name);
    return column.read<T>(0, column.rows());
  }
  std::size_t count(const std::string& name) {
    std::int64_t rows = 0;
    load(name + "/count", rows);
    if (rows < 0)
      throw hdf5::Failure(name + " has a negative length");
    return static_cast<std::size_t>(rows);
  }

  hid_t group_;
};

}  // namespace blocks::output
