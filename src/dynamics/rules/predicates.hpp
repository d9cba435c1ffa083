// The exact predicates, which the contact rule uses in every run.
#pragma once

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

using geometry::Vec2;

/// Predicates that are exact for the stored doubles. They are specified in
/// geometry/contact_predicates.hpp. Every predicate class of PairRule needs these
/// members.
struct ExactPredicates {
  static constexpr bool far_sides = true;  ///< far axes and contacts do not act
  static constexpr bool joints = true;     ///< third parts hide axes and ends of sides
  static constexpr bool faces = true;      ///< all four ends of two faces may act

  /// [L] Returns the depth of c below the side p1 p2, with an error bound.
  static geometry::filter::Estimate depth(const Vec2& c, const Vec2& p1, const Vec2& p2,
                                          double per_length) {
    return geometry::filter::depth(c, p1, p2, per_length);
  }
  static int depth_sign(const geometry::filter::Estimate& depth, const Vec2& c,
                        const Vec2& p1, const Vec2& p2) {
    if (depth.positive())
      return 1;
    return depth.negative() ? -1 : geometry::overlap_sign(c, p1, p2);
  }
  static bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::near_or_inside(c, p1, p2);
  }
  static bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::between(c, p1, p2);
  }
  static bool edges_face(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                         const Vec2& q2) {
    return geometry::edges_face(p1, p2, q1, q2);
  }
  static int turn_sign(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
    return geometry::turn_sign(p1, p2, q1, q2);
  }
  static int compare_depths(const Vec2& c, const Vec2& p1, const Vec2& p2,
                            const Vec2& d, const Vec2& q1, const Vec2& q2) {
    return geometry::compare_depths(c, p1, p2, d, q1, q2);
  }
  static int compare_slopes(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                            const Vec2& q2, const Vec2& r1, const Vec2& r2) {
    return geometry::compare_slopes(p1, p2, q1, q2, r1, r2);
  }
  /// Returns whether the side p2 q of a convex part is in line with the side p1 p2. The
  /// far corner of each must be within the slack of the other side's line.
  static bool in_line(const Vec2& p1, const Vec2& p2, const Vec2& q) {
    return (p2 - p1).dot(q - p2) > 0.0 && geometry::near_or_inside(q, p2, p1) &&
           geometry::near_or_inside(p1, q, p2);
  }
};

}  // namespace blocks::dynamics
