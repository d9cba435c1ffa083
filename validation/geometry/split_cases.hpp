// Random and awkward cuts of one outline, shared by the study and the tests. A family
// and a number give the same case on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "geometry/split.hpp"

namespace blocks::validation {

/// One call of split_outline.
struct SplitCase {
  geometry::Polygon outline;  ///< [L] simple and clockwise
  geometry::SplitLine line;
  double min_area = 0.0;  ///< [L^2]
};

/// One kind of line; outlines of every kind occur in each family.
struct SplitFamily {
  std::string_view name;
  int weight;  ///< share of the cases of a run, in hundredths
};

/// Returns all families in the order of the report. Their weights add up to 100.
std::span<const SplitFamily> split_families();

/// Makes a case of the family with this index.
SplitCase make_split_case(std::size_t family, std::uint64_t number);

}  // namespace blocks::validation
