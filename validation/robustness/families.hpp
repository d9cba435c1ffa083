// Random layers of every awkward kind, replayable from (family, number): made of whole
// numbers and decimals only, so that they are the same on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "geometry/layer.hpp"

namespace blocks::robustness {

/// One kind of layer.
struct Family {
  std::string_view name;
  std::string_view about;
  int weight;   ///< share of the layers of a run, in thousandths
  bool refuse;  ///< quads that are no layers: each has to be refused
  geometry::LayerRequest (*make)(std::uint64_t number);
};

/// All families, in the order of the report. The weights add up to 1000.
std::span<const Family> families();

}  // namespace blocks::robustness
