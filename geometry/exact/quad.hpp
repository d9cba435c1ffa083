// PRIVATE to geometry/: the quadrilateral of a layer and the straight sides that divide
// it, on exact rationals.
#pragma once

#include <optional>
#include <vector>

#include "geometry/exact/numbers.hpp"
#include "geometry/random.hpp"

namespace blocks::geometry::exact {

/// A strictly convex, clockwise layer: bottom line BL-BR, top line TL-TR.
struct Quad {
  Point bl, tl, tr, br;
  Vector bottom() const { return br - bl; }
  Vector top() const { return tr - tl; }
  /// The mid-line joins the middles of the two ends; (B(s) + T(s)) / 2 lies on it.
  Vector middle() const { return (bottom() + top()) / Rational(2); }
  Point middle(const Rational& s) const {
    return CGAL::midpoint(bl, tl) + middle() * s;
  }
  /// Length of the mid-line over the height of the layer. The height, "mean distance
  /// between the two lines", is area / length of the mid-line (the distance itself when
  /// they are parallel), so a width of f mid-lines has width/height = f * this:
  /// rational, and ties written in decimals are decided as written.
  Rational length_to_height() const;
};

/// Where a side meets the bottom and the top line, as fractions from the left.
struct Side {
  Fraction bottom;
  Fraction top;
};

/// Strictly to the left of, along both lines.
inline bool left_of(const Side& a, const Side& b) {
  return a.bottom < b.bottom && a.top < b.top;
}

/// Finds the sides of one quad.
class SideFinder {
 public:
  explicit SideFinder(const Quad& quad);

  /// The line through the mid-line at s, turned anticlockwise from the normal by the
  /// angle with this tangent. Nothing where it is parallel to the bottom or the top
  /// line.
  std::optional<Side> through(const Rational& s, double tangent) const;

 private:
  // The side through M + s m has the direction n - t m, with n normal to m and as long.
  // It meets the line p + f v at f = (s m.m + (M - p) x n - t (M - p) x m) /
  // (v x n - t v x m). These four products, all in whole numbers of one unit.
  struct Line {
    Integer start_normal, start_middle, along_normal, along_middle;
  };
  std::optional<Fraction> meet(const Line& line, const Fraction& s,
                               const Fraction& tangent) const;

  Integer squared_middle_;  // m.m in the same unit
  Line bottom_, top_;
};

/// Interior sides of a layer with a drawn angle each (ORIENT,
/// docs/departures.md#orient).
struct OrientedSides {
  std::vector<Side> sides;  ///< one per place, the ends 0 and 1 included
  int redrawn = 0;          ///< angles drawn again
  int redrawn_sides = 0;    ///< sides with an angle drawn again
  int ruled = 0;
};

/// places: increasing fractions of the mid-line, 0 and 1 included. numbers: which block
/// of the layer ends at each place (names its random stream). Angles in degrees.
/// Never crosses: 0 < s1 < s2 < ... < 1 strictly along both lines. Nothing where two
/// neighbours leave so little room that no tangent that is a double fits between them.
std::optional<OrientedSides> orient_sides(const Quad& quad,
                                          const std::vector<Rational>& places,
                                          const std::vector<std::size_t>& numbers,
                                          const Rational& angle_min,
                                          const Rational& angle_max, StreamKey stream);

/// count random widths as fractions of the mid-line, given by the sides between them
/// (0 and 1 included): width/height in [0.2, 3.0] and the sum 1, exactly. Needs
/// count * 0.2 <= length_to_height <= count * 3.
///
/// Law: independent uniform widths between the limits; where they do not add up to the
/// line, all are drawn towards one limit in proportion to their distance from it: the
/// lower one when the sum is too large, the upper one when it is too small. Every block
/// has the same law, whatever its place, and mean 1/count.
std::vector<Rational> random_places(int count, const Rational& length_to_height,
                                    StreamKey stream);

/// The limits of random widths (report A.2.4).
Rational least_width_to_height();
Rational greatest_width_to_height();

}  // namespace blocks::geometry::exact
