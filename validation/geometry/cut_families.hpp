// Random networks of joints of every difficult kind. A family and a number give the
// same network on every machine, because only whole numbers and decimals are used.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "geometry/cut.hpp"

namespace blocks::validation {

/// One kind of network.
struct CutFamily {
  std::string_view name;
  std::string_view about;
  int weight;  ///< share of the networks of a run, in thousandths
  geometry::CutRequest (*make)(std::uint64_t number);
};

/// Returns all families in the order of the report. Their weights add up to 1000.
std::span<const CutFamily> cut_families();

}  // namespace blocks::validation
