#include "audit/third_part.hpp"

#include <algorithm>
#include <utility>

#include "geometry/contact_constants.hpp"

namespace blocks::audit {
namespace {

Line side_of(const ShapeAxis& axis) { return side_of(axis.own, axis.side); }
const Point& corner_of(const ShapeAxis& axis) {
  return axis.other[static_cast<std::size_t>(axis.corner)];
}
Length depth_of(const ShapeAxis& axis) { return side_of(axis).depth(corner_of(axis)); }

/// Returns the foot of a point on the line of a side, from its start, in units of
/// length2 of the length.
Whole foot(const Line& side, const Point& point) {
  return dot(point - side.start, side.along);
}

/// One of two parts, shifted out of the other one through the axis, and a third part.
/// In a lattice that is finer by L^2 the shift is whole.
struct Shifted {
  Shape part, third;
  Point forward;   ///< way of the part along the side, from its start to its end
  Length before;   ///< the separating shift of the two before the shift
  Length overlap;  ///< the depth of their least axis after it, in the coarse lattice

  Shifted(const ShapeAxis& axis, const Shape& third_part, ThirdOf whose) {
    const Line e = side_of(axis);
    const Whole fine = e.length2(), way = whose == ThirdOf::own ? 1 : -1;
    forward = (way * fine) * e.along;
    part = refined(whose == ThirdOf::own ? axis.other : axis.own, fine,
                   (way * e.area2(corner_of(axis))) * left_of(e.along));
    third = refined(third_part, fine, {0, 0});
    overlap = separating_shift(part, third) / fine;
    before =
        separating_shift(whose == ThirdOf::own ? axis.other : axis.own, third_part);
  }
  /// Returns whether the third part blocks the shift, which had the length `depth`.
  bool is_blocked(const Length& depth) const {
    return overlap >= Dyadic(geometry::remaining_share) * depth &&
           overlap >= Dyadic(geometry::remaining_overlap) * before;
  }
  Ratio slide_forward() const { return way_out(part, forward, third); }
  Ratio slide_backward() const { return way_out(part, Whole(-1) * forward, third); }
};

/// Returns whether a point is outside each side of a shape by at most a distance. The
/// point is in a lattice that is finer by a factor.
bool is_near(const Point& point, const Whole& fine, const Shape& shape,
             const Length& distance) {
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Line side = side_of(shape, static_cast<int>(i));
    const Length depth = Line{fine * side.start, side.along}.depth(point);
    if (depth / fine < -distance)
      return false;
  }
  return true;
}

/// Returns whether a point is at most a distance away from a shape.
bool is_within(const Point& point, const Shape& shape, const Length& distance) {
  bool is_inside = true;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Line side = side_of(shape, static_cast<int>(i));
    const Whole area2 = side.area2(point), at = foot(side, point);
    is_inside = is_inside && sign(area2) >= 0;
    const Point apart = point - side.start;
    const Whole to_start2 = dot(apart, apart);
    if (sign(at) >= 0 && at <= side.length2()) {
      if (Length{abs(area2), side.length2()} <= distance)
        return true;
    } else if (sign(to_start2) == 0 || Length{to_start2, to_start2} <= distance) {
      return true;  // the end of the side is the start of another one
    }
  }
  return is_inside;
}

/// Returns whether a ray meets a shape within a distance. The ray starts in a lattice
/// that is finer by a factor.
bool ray_meets(const Line& ray, const Whole& fine, const Shape& shape,
               const Length& distance) {
  const std::optional<Chord> inside = chord(ray, refined(shape, fine, {0, 0}));
  if (!inside || sign(inside->end.n) < 0)
    return false;
  const Ratio at = std::max(inside->begin, Ratio{0});
  const Whole length2 = ray.length2();
  return Length{at.n * length2, length2} / (at.d * fine) <= distance;
}

/// The feet of the end and the start of the facing side. Without one, both are that of
/// the corner. The unit is that of foot().
struct Feet {
  Whole low, high;
  explicit Feet(const ShapeAxis& axis) {
    const Line e = side_of(axis);
    low = high = foot(e, corner_of(axis));
    if (!axis.facing)
      return;
    const Line f = side_of(axis.other, *axis.facing);
    high = foot(e, f.start), low = foot(e, f.start + f.along);
  }
};

/// Returns whether the third part is at the contact point, within the width of a closed
/// joint.
bool is_local(const ShapeAxis& axis, const Shape& third, ThirdOf whose) {
  const Shape& moves = whose == ThirdOf::own ? axis.other : axis.own;
  const Length width =
      std::min(Dyadic(geometry::joint_width) *
                   std::max(depth_of(axis), separating_shift(moves, third)),
               Dyadic(geometry::widest_joint) *
                   std::min(longest_side(axis.own), longest_side(axis.other)));
  if (whose == ThirdOf::other && !axis.facing)
    return is_within(corner_of(axis), third, width);
  const Line e = side_of(axis);
  const Whole length2 = e.length2();
  const Feet feet(axis);
  const auto on_side = [&](const Whole& at) {
    return std::clamp(at, Whole(0), length2);
  };
  const Whole middle2 = on_side(feet.low) + on_side(feet.high);  // twice the middle
  if (whose == ThirdOf::own) {
    const Whole fine = 2 * length2;
    const Point point = fine * e.start + middle2 * e.along;
    return ray_meets({point, left_of(e.along)}, fine, third, width);
  }
  const Line f = side_of(axis.other, *axis.facing);
  const Whole fine = 2 * (feet.high - feet.low);
  const Point point = fine * f.start + (2 * feet.high - middle2) * f.along;
  return ray_meets({point, left_of(f.along)}, fine, third, width);
}

/// Returns by how much the foot of the corner is beyond an end of the side, in the unit
/// of foot(). It is not positive if the foot is between the ends.
Whole beyond_end(const ShapeAxis& axis) {
  const Line e = side_of(axis);
  const Whole at = foot(e, corner_of(axis));
  return std::max(Whole(-at), Whole(at - e.length2()));
}

}  // namespace

std::optional<Obstacle> find_obstacle(const ShapeAxis& axis, const Shape& third,
                                      ThirdOf whose) {
  const Shifted shifted(axis, third, whose);
  if (!shifted.is_blocked(depth_of(axis)) || !is_local(axis, third, whose))
    return std::nullopt;
  const Ratio forward = shifted.slide_forward(), backward = shifted.slide_backward();
  const Feet feet(axis);
  const Whole length2 = side_of(axis).length2();
  Obstacle found{shifted.overlap,
                 {backward, Ratio{feet.high, length2} - backward},
                 {forward, Ratio{length2 - feet.low, length2} - forward}};
  if (forward < backward)  // of equal slides, the one to the start is the shorter
    std::swap(found.shorter, found.longer);
  const auto is_way = [&](const Obstacle::Slide& slide) {
    return slide.rest >= slide.length &&
           slide.length <= Dyadic(geometry::longest_way) * found.shorter.length;
  };
  found.hides = !is_way(found.shorter) && !is_way(found.longer);
  return found;
}

bool is_in_notch(const ShapeAxis& axis, const Shape& third) {
  const Whole beyond = beyond_end(axis);
  if (sign(beyond) <= 0)
    return false;
  const Shifted shifted(axis, third, ThirdOf::own);
  if (!shifted.is_blocked(depth_of(axis)))
    return false;
  const Line e = side_of(axis);
  const bool is_before = sign(foot(e, corner_of(axis))) < 0;
  const Ratio slide = is_before ? shifted.slide_forward() : shifted.slide_backward();
  return Ratio{2 * slide.n, slide.d} >= Ratio{beyond, e.length2()};
}

bool is_at_joint(const ShapeAxis& axis, const Shape& third, const Length& width) {
  if (sign(beyond_end(axis)) <= 0)
    return false;
  const Line e = side_of(axis);
  const Point& corner = corner_of(axis);
  const Whole fine = e.length2();
  const Point at = fine * e.start + foot(e, corner) * e.along;
  bool is_outside = false;
  for (std::size_t i = 0; i < third.size(); ++i)
    is_outside =
        is_outside || sign(side_of(third, static_cast<int>(i)).area2(corner)) <= 0;
  return is_outside && is_near(at, fine, third, width);
}

}  // namespace blocks::audit
