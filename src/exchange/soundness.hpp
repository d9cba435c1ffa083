// Whether outlines make blocks: each one checked exactly, every pair that overlaps, and
// corners that meet a neighbour's side or miss a neighbour's corner by a hair.
#pragma once

#include <vector>

#include "geometry/overlap.hpp"
#include "geometry/polygon.hpp"

namespace blocks::exchange {

struct BadOutline {
  int block = 0;  ///< from 0
  geometry::OutlineCheck check;
};

/// A corner of one block and a side or corner of another. Indices from 0, of corners
/// and sides once the outline runs clockwise.
struct Meeting {
  int block = 0, corner = 0;      ///< the corner
  int other = 0, side = 0;        ///< the side, or the corner it begins with
  double distance = 0.0;          ///< [L] 0: exactly on the side, decided exactly
  geometry::Vec2 place = {0, 0};  ///< [L] the corner
};

struct Soundness {
  std::vector<BadOutline> bad;
  std::vector<int> turned;  ///< blocks that run anticlockwise
  std::vector<int> concave;
  /// Of the good outlines; those by rounding alone (at most 1e-9 of the smaller block)
  /// apart, for decimals cannot say where two sloping lines meet.
  std::vector<geometry::BlockOverlap> overlaps, roundings;
  std::vector<Meeting> on_sides;  ///< T-junctions, exact and within the tolerance
  /// Points within the tolerance of each other, yet not the same: each pair once.
  std::vector<Meeting> near_corners;

  bool sound() const { return bad.empty() && overlaps.empty(); }
};

/// A corner within this part of the size of the whole of a side or of another corner
/// meets it.
inline constexpr double meeting_tolerance = 1e-7;

/// outlines: either sense, [L]. Law: turning or renumbering outlines changes nothing
/// but the numbers.
Soundness examine(const std::vector<geometry::Polygon>& outlines);

}  // namespace blocks::exchange
