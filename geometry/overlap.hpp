// Which blocks overlap at the start: a report for the user, decided exactly. Knows
// nothing of contacts.
#pragma once

#include <string>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Two outlines whose interiors intersect.
struct BlockOverlap {
  int first = 0;      ///< index of the outline, from 0; first < second
  int second = 0;     ///< index of the other
  double area = 0.0;  ///< [L^2] of the intersection, rounded; 0: below any double
  Vec2 place = Vec2::Zero();  ///< [L] a point of it: centroid, rounded
  /// [L] shortest shift that separates the two, rounded; of concave outlines the
  /// largest such shift among their convex pieces, which is no more than theirs
  double depth = 0.0;
};

/// How areas, depths and places are calculated: thin overlaps exactly, which takes some
/// 30 microseconds each, or all in doubles, which leave a thin one few digits.
enum class Figures { exact, quick };

/// Every pair of outlines whose interiors intersect, in order of (first, second).
/// outlines: simple and clockwise, [L]; concave ones are welcome. The decision is
/// exact; touching along sides or at corners does not count. Laws: the order of the
/// outlines does not matter; no pair is reported for the cells of a certified tiling.
/// layer: for each outline which certified tiling it is a cell of, 0: none; pairs of
/// one tiling are known to be disjoint and not looked at. The search ends at
/// most_overlaps pairs: whoever has so many wants no list of them.
std::vector<BlockOverlap> overlapping_pairs(const std::vector<Polygon>& outlines,
                                            const std::vector<int>& layer = {},
                                            Figures figures = Figures::exact);

/// What is positive, in so many digits, also where it rounds to nothing: "0.25",
/// "1.2e-31", "less than 5e-324".
std::string positive_text(double value, int digits);

constexpr std::size_t most_overlaps = 1'000'000;

}  // namespace blocks::geometry
