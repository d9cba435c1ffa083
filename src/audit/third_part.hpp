// What a third part changes where two others overlap: it hides an axis of them, or a
// side has no end there (docs/contact-rule.md).
#pragma once

#include <optional>

#include "audit/convex_shapes.hpp"

namespace blocks::audit {

/// An axis of two parts: a side of `own` and a corner of `other` below it.
struct ShapeAxis {
  const Shape& own;
  int side;
  const Shape& other;
  int corner;
  std::optional<int> facing;  ///< the side of `other` that faces the side
};

/// Whose third part a part is.
enum class ThirdOf { own, other };

/// A third part that blocks the shift out of the axis, at the contact point.
struct Obstacle {
  /// A slide along the side until the third part is left, in lengths of the side.
  struct Slide {
    Ratio length;
    Ratio rest;  ///< of the side after the slide
  };
  Length overlap;  ///< of the third part after the shift
  Slide shorter, longer;
  bool hides = true;  ///< neither slide is a way
};

/// Returns the obstacle that the third part is, unless the axis is free of it
/// (docs/contact-rule.md#hidden-axes, conditions 1 and 2).
std::optional<Obstacle> find_obstacle(const ShapeAxis& axis, const Shape& third,
                                      ThirdOf whose);

/// Returns whether the foot of the corner is beyond an end of the side, in a notch
/// between the side and a third part of own
/// (docs/contact-rule.md#sides-without-an-end).
bool is_in_notch(const ShapeAxis& axis, const Shape& third);

/// Returns whether the foot of the corner is beyond an end of the side, and within a
/// width of a third part of own that does not contain the corner.
bool is_at_joint(const ShapeAxis& axis, const Shape& third, const Length& width);

}  // namespace blocks::audit
