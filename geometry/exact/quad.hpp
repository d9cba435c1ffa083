// PRIVATE to geometry/: the quadrilateral of a layer and the straight sides that divide
// it, in exact rationals.
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
  /// The mid-line joins the midpoints of the two ends. If B(s) and T(s) are the points
  /// at fraction s of the bottom and the top line, it contains (B(s) + T(s)) / 2.
  Vector middle() const { return (bottom() + top()) / Rational(2); }
  Point middle(const Rational& s) const {
    return CGAL::midpoint(bl, tl) + middle() * s;
  }
  /// Returns the length of the mid-line over the height of the layer. The height, "mean
  /// distance between the two lines", is the area over the length of the mid-line. If
  /// the lines are parallel, it is their distance. A width of f mid-lines then has
  /// width/height = f * this, a rational, so ties written in decimals are decided as
  /// written.
  Rational length_to_height() const;
};

/// The intersections of a side with the bottom and the top line, as fractions from the
/// left.
struct Side {
  Fraction bottom;
  Fraction top;
};

/// Tests whether a is strictly to the left of b along both lines.
inline bool left_of(const Side& a, const Side& b) {
  return a.bottom < b.bottom && a.top < b.top;
}

/// Computes sides of one quadrilateral.
class SideFinder {
 public:
  explicit SideFinder(const Quad& quad);

  /// Returns the side through the mid-line at s, turned anticlockwise from the normal
  /// by the angle with this tangent. Returns nothing if it is parallel to the bottom or
  /// the top line.
  std::optional<Side> through(const Rational& s, double tangent) const;

 private:
  // The side through M + s m has the direction n - t m, where n is normal to m and has
  // the same length. It meets the line p + f v at f = (s m.m + (M - p) x n - t (M - p)
  // x m) / (v x n - t v x m). These are the four cross products, all as integers in one
  // common unit.
  struct Line {
    Integer start_normal, start_middle, along_normal, along_middle;
  };
  std::optional<Fraction> meet(const Line& line, const Fraction& s,
                               const Fraction& tangent) const;

  Integer squared_middle_;  // m.m in the same unit
  Line bottom_, top_;
};

/// Sides of a layer, each interior one with a random angle (ORIENT,
/// docs/departures.md#orient).
struct OrientedSides {
  std::vector<Side> sides;  ///< one per place, including the ends 0 and 1
  int redrawn = 0;          ///< number of redrawn angles
  int redrawn_sides = 0;    ///< number of sides with a redrawn angle
  int ruled = 0;            ///< number of sides that use the ruling
};

/// Draws the sides of a layer. places: increasing fractions of the mid-line, including
/// 0 and 1. numbers: number of the block of the layer that ends at each place; it
/// selects the random stream. Angles in degrees.
///
/// Sides never cross: 0 < s1 < s2 < ... < 1 strictly along both lines. Returns nothing
/// if two neighbours are so close that no side whose tangent is a double fits between
/// them.
std::optional<OrientedSides> orient_sides(const Quad& quad,
                                          const std::vector<Rational>& places,
                                          const std::vector<std::size_t>& numbers,
                                          const Rational& angle_min,
                                          const Rational& angle_max, StreamKey stream);

/// Draws `count` random widths and returns the sides between them as fractions of the
/// mid-line, including 0 and 1. width/height is in [0.2, 3.0] and the widths add up to
/// 1, exactly. Requires count * 0.2 <= length_to_height <= count * 3.
///
/// Distribution: independent uniform widths between the limits. If they do not add up
/// to the line, all are moved towards one limit in proportion to their distance from
/// it. This is the lower limit if the sum is too large, otherwise the upper one. Every
/// block has the same distribution, independent of its place, and the mean 1/count.
std::vector<Rational> random_places(int count, const Rational& length_to_height,
                                    StreamKey stream);

/// Return the limits of random widths (report A.2.4).
Rational min_width_to_height();
Rational greatest_width_to_height();

}  // namespace blocks::geometry::exact
