// Random layers of every difficult kind. A family and a number give the same layer on
// every machine, because only whole numbers and decimals are used.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "geometry/layer.hpp"

namespace blocks::validation {

/// One kind of layer.
struct Family {
  std::string_view name;
  std::string_view about;
  int weight;   ///< share of the layers of a run, in thousandths
  bool refuse;  ///< the quadrilaterals are not layers, so each must be refused
  geometry::LayerRequest (*make)(std::uint64_t number);
};

/// Returns all families in the order of the report. Their weights add up to 1000.
std::span<const Family> families();

}  // namespace blocks::validation
