// Every field of a model as text, so that tests can compare models.
#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "output/checkpoint/model_fields.hpp"

namespace blocks::samples {

/// Writes each field as text by its name. Doubles are written by their bits.
class Fields {
 public:
  std::map<std::string, std::string> all;

  template <class T> void operator()(const output::Field& field, const T& value) {
    put(field.name, value);
  }
  template <class R, class Visit>
  void records(const output::Field& list, const std::vector<R>& records,
               Visit&& visit) {
    all[list.name] = std::to_string(records.size());
    auto member = [&](const output::Field& at, const auto& value) {
      put(std::string(list.name) + "/" + at.name, value);
    };
    for (const R& record : records)
      visit(member, record);
  }
  template <class Map, class Visit>
  void materials(const output::Field& list, const Map& map, Visit&& visit) {
    all[list.name] = std::to_string(map.size());
    auto member = [&](const output::Field& at, const auto& value) {
      put(std::string(list.name) + "/" + at.name, value);
    };
    for (const auto& [number, material] : map)
      visit(member, number, material);
  }

 private:
  template <output::Number T> void put(const std::string& name, const T& value) {
    all[name] += bits(value);
  }
  void put(const std::string& name, const std::string& text) { all[name] = text; }
  void put(const std::string& name, const geometry::Decimal& number) {
    all[name] = number.digits() + "e" + std::to_string(number.exponent()) + " " +
                bits(number.value());
  }
  template <class T> void put(const std::string& name, const std::optional<T>& v) {
    all[name] = "none";
    if (v)
      put(name, *v);
  }
  template <class T> void put(const std::string& name, const std::vector<T>& v) {
    all[name] = std::to_string(v.size()) + ":";
    for (const T& value : v)
      all[name] += bits(value);
  }
  template <class D>
  void put(const std::string& name, const Eigen::PlainObjectBase<D>& m) {
    all[name] = std::to_string(m.rows()) + "x" + std::to_string(m.cols()) + ":";
    for (Eigen::Index i = 0; i < m.size(); ++i)
      all[name] += bits(m.data()[i]);
  }
  template <class T> static std::string bits(const T& value) {
    if constexpr (std::is_same_v<T, std::string>)
      return value + "\n";
    else if constexpr (std::is_same_v<T, double>)
      return std::to_string(std::bit_cast<std::uint64_t>(value)) + " ";
    else
      return std::to_string(static_cast<long long>(value)) + " ";
  }
};

/// Returns all fields of a model by name.
inline std::map<std::string, std::string> fields(const Model& model) {
  Fields result;
  output::visit_model(model, result);
  return result.all;
}

}  // namespace blocks::samples
