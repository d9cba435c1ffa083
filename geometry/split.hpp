// Cuts the outline of one block in two along a chord (CRACK, docs/cracks.md#the-cut).
// Exact on the given doubles; independent of blocks in motion and of the rule that asks
// for the cut.
#pragma once

#include <array>
#include <vector>

#include "geometry/tiling.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Where and how to cut.
struct SplitLine {
  Vec2 point;         ///< [L] of the line; the chord nearest to it is cut
  Vec2 along;         ///< direction of the line, not zero; its length does not matter
  double near = 0.0;  ///< [L] a crossing moves to a corner that is nearer, see below
};

/// Why an outline was not cut.
enum class SplitFault {
  none,
  no_chord,  ///< the line has no point inside the outline, or has no direction
  small,     ///< a piece would have an area less than the least one
  unsound,   ///< the certificate does not hold for the rounded or moved chord
};

/// One end of the chord.
struct ChordEnd {
  Vec2 place = {0, 0};  ///< [L] corner of both pieces
  int corner = -1;      ///< corner of the outline at this place; -1: a new corner
  int side = -1;        ///< side of the outline with the new corner; -1: at a corner
  double part = 0.0;    ///< of that side, from its first corner to the exact crossing
  double moved = 0.0;   ///< [L] from the exact crossing to the corner it moved to
};

/// One of the two pieces, (k) corners. It begins with its lowest corner of the old
/// outline.
struct SplitPiece {
  Polygon outline;  ///< [L] clockwise; the corners of the old outline keep their order
  /// (k) corner of the old outline at each corner; -1: a new corner
  std::vector<int> corner;
  /// (k) side of the old outline on which the side that begins here lies; -1: the chord
  std::vector<int> side;
  double area = 0.0;  ///< [L^2] rounded from the exact area
};

/// The result of split_outline. The ends are set unless the fault is `no_chord`, the
/// pieces if the certificate holds.
struct Split {
  SplitFault fault = SplitFault::none;
  /// The chord begins at ends[0], and its direction is that of SplitLine::along.
  std::array<ChordEnd, 2> ends;
  std::array<SplitPiece, 2> pieces;  ///< left and right of the chord
  /// Of the two pieces and the old outline with the new corners; empty if `no_chord`.
  TilingCertificate certificate;
};

/// Cuts a simple clockwise outline along the chord of the line that contains
/// line.point or is nearest to it; of two equally near ones, along the first in the
/// direction of the line. A chord is a maximal segment whose interior lies inside the
/// outline.
///
/// Crossings are exact. A crossing moves to a corner of its side if its exact distance
/// is less than line.near: to the nearer corner, of two equally near ones to the lower
/// number. Otherwise it is rounded once. On a slanted side each coordinate is rounded
/// towards the inside, on a side along an axis to the nearest double. If the rounded
/// place is a corner, the crossing has moved to this corner.
///
/// Refuses pieces whose exact area is less than min_area [L^2]; `unsound` takes
/// precedence over `small`. Guarantee: with fault `none`, both pieces are simple,
/// clockwise and at least min_area large, they have the chord in common in opposite
/// directions, and together they have the sides of the old outline, with the new
/// corners on them. Throws nothing but std::bad_alloc.
Split split_outline(const Polygon& outline, const SplitLine& line, double min_area);

}  // namespace blocks::geometry
