// PRIVATE to geometry/: MERGE on exact widths (report A.2.6, docs/departures.md#merge).
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/exact/numbers.hpp"
#include "geometry/merge.hpp"

namespace blocks::geometry::exact {

/// Which sides stay when slender blocks are absorbed: width/height < smallest, by the
/// next block on the right, the last one by its left neighbour, repeated.
/// sides: increasing fractions of the mid-line, 0 and 1 included. length_to_height: of
/// the mid-line, so that width/height is rational and a tie is decided as written.
/// record: one entry is added per block absorbed. Returns indices into sides, the ends
/// included.
std::vector<std::size_t> merge_slender(const std::vector<Rational>& sides,
                                       const Rational& length_to_height,
                                       const Rational& smallest,
                                       std::vector<Absorption>& record);

}  // namespace blocks::geometry::exact
