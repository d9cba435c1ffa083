// Checks whether outlines are valid blocks: each outline exactly, every pair that
// overlaps, and how the blocks meet.
#pragma once

#include <vector>

#include "geometry/joints.hpp"
#include "geometry/overlap.hpp"
#include "geometry/polygon.hpp"

namespace blocks::exchange {

/// An outline with a fault.
struct BadOutline {
  int block = 0;  ///< from 0
  geometry::OutlineCheck check;
};

/// The result of examine.
struct Soundness {
  std::vector<BadOutline> bad;
  std::vector<int> turned;  ///< blocks whose corners run anticlockwise
  std::vector<int> concave;
  /// Overlaps between outlines without fault. Those that rounding explains are in
  /// `roundings` (geometry/rounding.hpp), because decimals cannot represent every point
  /// where two sloping lines meet.
  std::vector<geometry::BlockOverlap> overlaps, roundings;
  geometry::Joints joints;  ///< T-junctions and gaps between outlines without fault
  std::size_t slits_by_rounding = 0;

  bool sound() const { return bad.empty() && overlaps.empty(); }
};

/// Examines the outlines, [L], clockwise or anticlockwise. Guarantee: reversing or
/// renumbering outlines changes only the numbers in the result.
Soundness examine(const std::vector<geometry::Polygon>& outlines);

}  // namespace blocks::exchange
