// Every field of a model as text, so that tests can compare models.
#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "output/model_fields.hpp"

namespace blocks::samples {

/// Writes each field as text by its name. Doubles are written by their bits.
class Fields {
 public:
  std::map<std::string, std::string> all;

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void operator()(const std::string& name, const T& value) { all[name] += bits(value); }
  void operator()(const std::string& name, const std::string& text) {
    all[name] = text;
  }
  void operator()(const std::string& name, const geometry::Decimal& number) {
    all[name] = number.digits() + "e" + std::to_string(number.exponent()) + " " +
                bits(number.value());
  }
  template <class T>
  void operator()(const std::string& name, const std::optional<T>& v) {
    all[name] = "none";
    if (v)
      (*this)(name, *v);
  }
  template <class T> void operator()(const std::string& name, const std::vector<T>& v) {
    all[name] = std::to_string(v.size()) + ":";
    for (const T& value : v)
      all[name] += bits(value);
  }
  template <class D>
  void operator()(const std::string& name, const Eigen::PlainObjectBase<D>& m) {
    all[name] = std::to_string(m.rows()) + "x" + std::to_string(m.cols()) + ":";
    for (Eigen::Index i = 0; i < m.size(); ++i)
      all[name] += bits(m.data()[i]);
  }
  template <class R, class Visit>
  void records(const std::string& name, const std::vector<R>& list, Visit&& visit) {
    all[name] = std::to_string(list.size());
    for (const R& record : list) {
      auto member = [&](const char* at, const auto& v) { (*this)(name + "/" + at, v); };
      visit(member, record);
    }
  }
  template <class Map, class Visit>
  void materials(const std::string& name, const Map& map, Visit&& visit) {
    all[name] = std::to_string(map.size());
    for (const auto& [number, material] : map) {
      auto member = [&](const char* at, const auto& v) { (*this)(name + "/" + at, v); };
      visit(member, number, material);
    }
  }

 private:
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
