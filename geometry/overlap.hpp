// Finds the blocks that overlap at the start, decided exactly. A report for the user,
// independent of contacts.
#pragma once

#include <string>
#include <vector>

#include "geometry/step_progress.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Two outlines whose interiors intersect.
struct BlockOverlap {
  int first = 0;      ///< index of the outline, from 0; first < second
  int second = 0;     ///< index of the other outline
  double area = 0.0;  ///< [L^2] of the intersection, rounded; 0 if below any double
  Vec2 place = Vec2::Zero();  ///< [L] about the centroid of the intersection
  /// [L] shortest translation that separates the two, rounded. For concave outlines it
  /// is the largest one among pairs of their convex parts, a lower bound.
  double depth = 0.0;
};

/// How areas, depths and places are computed. `exact` computes thin overlaps exactly,
/// which takes about 30 microseconds each. `quick` uses doubles only, which leave a
/// thin overlap few correct digits.
enum class Figures { exact, quick };

/// Returns every pair of outlines whose interiors intersect, in order of (first,
/// second). outlines: simple and clockwise, convex or concave, [L]. The decision is
/// exact; touching along sides or at corners does not count. Guarantees: the result
/// does not depend on the order of the outlines, unless there are more pairs than
/// max_overlaps. No pair is reported for the cells of a
/// certified tiling.
///
/// layer: for each outline, the number of the certified tiling of which it is a cell,
/// or 0. Pairs of one tiling are known to be disjoint and are not tested. The search
/// stops after max_overlaps pairs, because longer lists are of no use. A report of
/// progress may throw.
std::vector<BlockOverlap> overlapping_pairs(const std::vector<Polygon>& outlines,
                                            const std::vector<int>& layer = {},
                                            Figures figures = Figures::exact,
                                            StepProgress* progress = nullptr);

/// Formats a positive value with so many significant digits, even if it has been
/// rounded to zero: "0.25", "1.2e-31", "less than 5e-324".
std::string positive_text(double value, int digits);

constexpr std::size_t max_overlaps = 1'000'000;

}  // namespace blocks::geometry
