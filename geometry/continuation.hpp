// Decides what a third polygon changes where two others overlap: it may continue one of
// them, so that a side is not on the boundary of the union or has no end
// (docs/contact-rule.md). The answers are exact for the stored doubles. Independent of
// blocks and of the time loop.
#pragma once

#include "geometry/outline.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// A side of a convex polygon and the corner of another one that is deepest below it,
/// both by index. The corner is inside the side.
struct PolygonAxis {
  Outline own;  ///< the polygon with the side
  int side = 0;
  Outline other;  ///< the polygon with the corner
  int corner = 0;
  int facing = -1;  ///< the side of `other` that faces the side; -1 if none does
};

/// Which of the two polygons of an axis a third one continues.
enum class Continues { own, other };

/// Returns whether a third polygon hides the axis, because it continues one of the two
/// polygons there (docs/contact-rule.md#hidden-axes).
bool is_hidden_by(const PolygonAxis& axis, Outline third, Continues which);

/// Returns whether the side of an axis has no end where the foot of the corner is
/// beyond it, because a third polygon rises there
/// (docs/contact-rule.md#sides-without-an-end). The result is false if the foot is
/// between the ends.
bool is_in_notch_of(const PolygonAxis& axis, Outline third);

/// Returns whether the foot of corner c on the line p1 p2 is beyond an end of that
/// side, at the joint between the side and a third polygon, which does not contain the
/// corner (docs/contact-rule.md#sides-without-an-end). least_axis: the axis of least
/// depth of the two polygons.
bool is_at_joint_with(const Vec2& c, const Vec2& p1, const Vec2& p2,
                      const PolygonAxis& least_axis, Outline third);

/// Returns whether a segment of a side, of positive length, lies in another convex
/// polygon, borders included.
bool crosses(Outline polygon, int side, Outline other);

/// Returns whether the depth of corner c below the line p1 p2 exceeds twice the
/// diameter of the region that two convex polygons have in common. Without a common
/// region the result is false.
bool exceeds_common_region(const Vec2& c, const Vec2& p1, const Vec2& p2, Outline one,
                           Outline other);
/// Returns whether the depth of corner c below the line p1 p2 exceeds twice the
/// shortest shift that separates two convex polygons. It does if they are separate.
bool exceeds_separating_shift(const Vec2& c, const Vec2& p1, const Vec2& p2,
                              Outline one, Outline other);

}  // namespace blocks::geometry
