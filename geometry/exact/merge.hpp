// PRIVATE to geometry/: MERGE on exact widths (report A.2.6, docs/departures.md#merge).
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/exact/numbers.hpp"
#include "geometry/merge.hpp"

namespace blocks::geometry::exact {

/// Absorbs slender blocks, those with width/height < smallest, and returns the sides
/// that remain. A slender block is absorbed by the next block on its right, the last
/// one by its left neighbour. This repeats until no slender block has a neighbour to
/// absorb it.
///
/// sides: increasing fractions of the mid-line, including 0 and 1. length_to_height:
/// that of the mid-line, so that width/height is rational and a tie is decided as
/// written. record: receives one entry per absorbed block. Returns indices into sides,
/// including both ends.
std::vector<std::size_t> merge_slender(const std::vector<Rational>& sides,
                                       const Rational& length_to_height,
                                       const Rational& smallest,
                                       std::vector<Absorption>& record);

}  // namespace blocks::geometry::exact
