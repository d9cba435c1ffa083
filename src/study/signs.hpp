// The tests of a corner on an edge, exact and as in 1982.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/contact_predicates.hpp"

namespace blocks::study {

using geometry::Vec2;

/// The tests of the contact rule, exact for the stored doubles.
struct ExactSigns {
  static int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::overlap_sign(c, p1, p2);
  }
  static bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                         const Vec2& p2) {
    return geometry::faces_edge(c, neighbour, p1, p2);
  }
};

/// The tests of the report in doubles, without control of round-off. A corner on the
/// limit of an edge is inside.
struct PrintedSigns {
  /// The sign of (19) as printed, in absolute coordinates.
  static int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const double twice = p1.x() * c.y() + c.x() * p2.y() + p2.x() * p1.y() -
                         p1.y() * c.x() - c.y() * p2.x() - p2.y() * p1.x();
    return int{twice > 0} - int{twice < 0};
  }
  /// Whether the corner is between the ends of the edge.
  static bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const Vec2 e = p2 - p1;
    const double along = Vec2(c - p1).dot(e);
    return along >= 0 && e.dot(e) - along >= 0;
  }
  /// Equation (20) for one tangent of a corner.
  static bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                         const Vec2& p2) {
    const Vec2 e = p2 - p1, t = neighbour - c;
    constexpr double angle = geometry::facing_angle * std::numbers::pi / 180;
    return geometry::cross(e, t) / (e.norm() * t.norm()) >= -std::sin(angle);
  }
};

}  // namespace blocks::study
