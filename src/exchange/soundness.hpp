// Whether outlines make blocks: each one checked exactly, every pair that overlaps, and
// how the blocks meet.
#pragma once

#include <vector>

#include "geometry/joints.hpp"
#include "geometry/overlap.hpp"
#include "geometry/polygon.hpp"

namespace blocks::exchange {

struct BadOutline {
  int block = 0;  ///< from 0
  geometry::OutlineCheck check;
};

struct Soundness {
  std::vector<BadOutline> bad;
  std::vector<int> turned;  ///< blocks that run anticlockwise
  std::vector<int> concave;
  /// Of the good outlines; those by rounding alone apart (geometry/rounding.hpp), for
  /// decimals cannot say where two sloping lines meet.
  std::vector<geometry::BlockOverlap> overlaps, roundings;
  geometry::Joints joints;  ///< T-junctions, and gaps between the good ones
  std::size_t slits_by_rounding = 0;

  bool sound() const { return bad.empty() && overlaps.empty(); }
};

/// outlines: either sense, [L]. Law: turning or renumbering outlines changes nothing
/// but the numbers.
Soundness examine(const std::vector<geometry::Polygon>& outlines);

}  // namespace blocks::exchange
