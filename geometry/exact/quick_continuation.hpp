// PRIVATE to geometry/: the answers to questions of continuation.hpp that plain doubles
// decide for certain. Values and bounds are those of the contact predicates
// (docs/predicates.md); u = 2^-53. A length or a sum that leaves the range of doubles
// decides nothing, because its bound is infinite or NaN, or because it is not moderate.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/contact_constants.hpp"
#include "geometry/contact_predicates.hpp"
#include "geometry/continuation.hpp"

namespace blocks::geometry::quick {

using filter::Estimate;

/// More than the relative error of a few operations with moderate numbers.
inline constexpr double more = 1.0 + 1e-14, less = 1.0 - 1e-14;

/// Tells whether the square of a length and its root are exact but for a few u, and
/// finite.
inline bool is_moderate(double length2) {
  return length2 > 0x1p-900 && length2 < 0x1p900;
}

/// A side of a polygon in plain doubles.
struct Line {
  const Vec2 &start, &end;
  double length2;
  Line(const Vec2& p1, const Vec2& p2)
      : start(p1), end(p2), length2(filter::squared_length(p1, p2)) {}
  /// Twice the area below the side. The bound is twice that of the filter.
  Estimate area(const Vec2& corner) const {
    const Estimate found = filter::overlap(corner, start, end);
    return {found.value, 2.0 * found.bound};
  }
};

inline Line line_of(Outline polygon, int side) {
  const std::size_t i = static_cast<std::size_t>(side), next = i + 1;
  return {polygon[i], polygon[next < polygon.size() ? next : 0]};
}

/// Returns whether condition(side) is true for all sides of a polygon.
template <class Condition> bool all_sides(Outline polygon, const Condition& condition) {
  for (int i = 0; i < static_cast<int>(polygon.size()); ++i)
    if (!condition(line_of(polygon, i)))
      return false;
  return true;
}

/// Returns whether all corners are less deep below a side than a limit, which is a
/// depth times the length of the side. A limit that may have overflowed decides
/// nothing.
inline bool all_above(Outline corners, const Line& side, double limit) {
  if (!(limit < 0x1p1000))
    return false;
  for (const Vec2& corner : corners)
    if (const Estimate area = side.area(corner); !(area.value + area.bound < limit))
      return false;
  return true;
}
/// Returns whether a corner is at least as deep below a side as a limit.
inline bool any_below(Outline corners, const Line& side, double limit) {
  for (const Vec2& corner : corners)
    if (const Estimate area = side.area(corner); area.value - area.bound >= limit)
      return true;
  return false;
}

/// Returns -1, 0 or 1 for a corner outside a side, on its line, or below it, if that is
/// certain. At both ends of the side it is 0.
inline std::optional<int> sign_below(const Line& side, const Vec2& corner,
                                     const Estimate& area) {
  if (corner == side.start || corner == side.end)
    return 0;
  if (area.positive())
    return 1;
  return area.negative() ? std::optional(-1) : std::nullopt;
}

/// Bounds of a number.
struct Bounds {
  double min, max;
};

/// The part of a side that lies in a convex polygon, from and to places along it in
/// [0, 1]. It is open if doubles cannot tell which sides of the polygon are crossed.
struct PartOfSide {
  Bounds from{0.0, 0.0}, to{1.0, 1.0};
  bool is_open = false;
  bool is_certain() const { return from.max < to.min; }
  bool is_empty() const { return from.min >= to.max; }
};

inline PartOfSide part_in(Outline polygon, int side, Outline other) {
  const Line own = line_of(polygon, side);
  PartOfSide part;
  bool is_empty = false;
  all_sides(other, [&](const Line& line) {
    const Estimate first = line.area(own.start), last = line.area(own.end);
    const std::optional<int> before = sign_below(line, own.start, first),
                             after = sign_below(line, own.end, last);
    part.is_open = !before || !after;
    if (part.is_open || (*before >= 0 && *after >= 0))
      return !part.is_open;
    is_empty = *before <= 0 && *after <= 0;
    if (is_empty)
      return false;
    // The line is crossed at first / (first - last). The signs differ, and each error
    // is at most half of its bound and of the value. So the error of the quotient is at
    // most the larger bound over the difference, and 2u.
    const double length = std::abs(first.value - last.value),
                 at = std::abs(first.value) / length,
                 bound =
                     2.0 * (std::max(first.bound, last.bound) / length) + filter::u8;
    if (*before > 0)
      part.to = {std::min(part.to.min, at - bound), std::min(part.to.max, at + bound)};
    else
      part.from = {std::max(part.from.min, at - bound),
                   std::max(part.from.max, at + bound)};
    part.is_open = !(length < 0x1p900);
    return !part.is_open;
  });
  if (is_empty)
    return {{1.0, 1.0}, {0.0, 0.0}};
  return part;
}

/// Tells whether a segment of a side, of positive length, lies in another convex
/// polygon, if that is certain.
inline std::optional<bool> crosses(Outline polygon, int side, Outline other) {
  const PartOfSide part = part_in(polygon, side, other);
  if (part.is_open)
    return std::nullopt;
  if (part.is_certain())
    return true;
  return part.is_empty() ? std::optional(false) : std::nullopt;
}

/// Tells whether the depth of a corner below a side exceeds twice the shortest shift
/// that separates two polygons, if that is certain.
inline std::optional<bool> exceeds_separating_shift(const Vec2& c, const Vec2& p1,
                                                    const Vec2& p2, Outline one,
                                                    Outline other) {
  const Line e(p1, p2);
  if (!is_moderate(e.length2))
    return std::nullopt;
  const Estimate area = e.area(c);
  const double value = area.value, bound = area.bound;
  if (value + bound <= 0.0)
    return false;
  // Bounds of the shift that the depth exceeds just so.
  const double scale = deepest_share * std::sqrt(e.length2);
  const double max = more * ((value + bound) / scale),
               min = less * ((value - bound) / scale);
  if (!(min > 0x1p-500))
    return std::nullopt;
  const auto holds = [&](Outline own, Outline corners) {
    return all_sides(own, [&](const Line& side) {
      return is_moderate(side.length2) &&
             any_below(corners, side, more * (max * std::sqrt(side.length2)));
    });
  };
  const auto frees = [&](Outline own, Outline corners) {
    return !all_sides(own, [&](const Line& side) {
      return !is_moderate(side.length2) ||
             !all_above(corners, side, less * (min * std::sqrt(side.length2)));
    });
  };
  if (holds(one, other) && holds(other, one))
    return false;
  return frees(one, other) || frees(other, one) ? std::optional(true) : std::nullopt;
}

/// Tells whether a polygon certainly does not overlap a third one after the shift
/// through an axis, or by less than `remaining_share` of the shift. So the third one
/// does not block it: the first condition of docs/contact-rule.md#hidden-axes.
inline bool is_free_after_shift(const PolygonAxis& axis, Outline third,
                                Continues which) {
  const Line e = line_of(axis.own, axis.side);
  if (!is_moderate(e.length2))
    return false;
  const bool moves_other = which == Continues::own;
  const Outline moving = moves_other ? axis.other : axis.own;
  const Vec2& corner = axis.other[static_cast<std::size_t>(axis.corner)];
  const filter::Cross area = filter::cross(corner, e.start, e.start, e.end);
  const double size = area.magnitude() + filter::underflow;
  // The shift in lengths of the side, and the overlap that is required.
  const double shift = area.value() / e.length2, shift_size = size / e.length2;
  const double depth = std::abs(area.value()) - filter::u8 * size;
  const double share =
      depth > 0.0 ? less * (remaining_share * (depth / std::sqrt(e.length2))) : 0.0;
  const Vec2 along = e.end - e.start;
  // Shifted outwards through the side, a corner gets less deep below a side of another
  // polygon that runs along, by the shift times the dot product of the two sides. The
  // shift has the error 9u of its terms, the dot product 4u, and two products and sums
  // add 3u: 16u. Used: 32u.
  const auto separates = [&](const Line& side, Outline corners, bool is_of_third) {
    if (!is_moderate(side.length2))
      return false;
    const double x = along.x() * (side.end.x() - side.start.x()),
                 y = along.y() * (side.end.y() - side.start.y());
    const double rise = shift * (x + y),
                 bound = 2.0 * filter::u16 * shift_size *
                         (std::abs(x) + std::abs(y) + filter::underflow);
    const double needed = less * (share * std::sqrt(side.length2));
    return all_above(corners, side,
                     (is_of_third == moves_other ? rise : -rise) + needed - bound -
                         filter::underflow);
  };
  return !all_sides(third,
                    [&](const Line& side) { return !separates(side, moving, true); }) ||
         !all_sides(moving,
                    [&](const Line& side) { return !separates(side, third, false); });
}

/// Returns the square of the length of the longest side.
inline double longest_side2(Outline polygon) {
  double most2 = 0.0;
  all_sides(polygon, [&](const Line& side) {
    most2 = std::max(most2, side.length2);
    return true;
  });
  return most2;
}

/// A number and the bound of its error.
using Foot = Estimate;

/// The foot of a point on a side, in lengths of the side. The dot product has the error
/// 4u of its terms, the square of the length 4u and the quotient u: 9u. Used: 16u.
inline Foot foot_on(const Line& side, const Vec2& point) {
  const filter::Dot along = filter::dot(point, side.start, side.end);
  return {along.value() / side.length2,
          (filter::u16 * along.magnitude() + filter::underflow) / side.length2 +
              filter::underflow};
}

/// A point and the bound of the error of each coordinate.
struct Place {
  Vec2 point;
  double bound = 0.0;
};

inline Place place_on(const Line& side, const Foot& foot) {
  const Vec2 along = side.end - side.start;
  const double size = std::abs(along.x()) + std::abs(along.y());
  return {side.start + foot.value * along,
          2.0 * foot.bound * size +
              filter::u8 * (std::abs(side.start.x()) + std::abs(side.start.y()) +
                            std::abs(foot.value) * size) +
              filter::underflow};
}

/// Bounds of the diameter of the common region of two polygons, or none if doubles
/// cannot tell. The lower one is positive only if there certainly is such a region.
inline std::optional<Bounds> common_diameter(Outline one, Outline other) {
  struct Vertex {
    Place place;
    bool is_certain;
  };
  constexpr int max_vertices = 64;
  std::array<Vertex, max_vertices> vertices;
  int count = 0;
  const auto add = [&](Outline polygon, Outline in) {
    for (int i = 0; i < static_cast<int>(polygon.size()); ++i) {
      const PartOfSide part = part_in(polygon, i, in);
      if (part.is_open || count + 2 > max_vertices)
        return false;
      if (part.is_empty())
        continue;
      for (const Bounds& at : {part.from, part.to})
        vertices[static_cast<std::size_t>(count++)] = {
            place_on(line_of(polygon, i), {0.5 * (at.min + at.max), at.max - at.min}),
            part.is_certain()};
    }
    return true;
  };
  if (!add(one, other) || !add(other, one))
    return std::nullopt;
  Bounds found{0.0, 0.0};
  for (int i = 0; i < count; ++i)
    for (int k = i + 1; k < count; ++k) {
      const Vertex& first = vertices[static_cast<std::size_t>(i)];
      const Vertex& last = vertices[static_cast<std::size_t>(k)];
      const double apart = (first.place.point - last.place.point).norm(),
                   bound = 2.0 * (first.place.bound + last.place.bound);
      found.max = std::max(found.max, more * apart + bound);
      if (first.is_certain && last.is_certain)
        found.min = std::max(found.min, less * apart - bound);
    }
  return found;
}

/// Tells whether the depth of a corner below a side exceeds twice the diameter of the
/// common region of two polygons, if that is certain.
inline std::optional<bool> exceeds_common_region(const Vec2& c, const Vec2& p1,
                                                 const Vec2& p2, Outline one,
                                                 Outline other) {
  const Line e(p1, p2);
  const std::optional<Bounds> diameter = common_diameter(one, other);
  if (!is_moderate(e.length2) || !diameter || !(diameter->max < 0x1p400))
    return std::nullopt;
  const Estimate area = e.area(c);
  const double scale = deepest_share * std::sqrt(e.length2);
  if (area.value + area.bound < less * scale * diameter->min)
    return false;
  const bool exceeds =
      area.value - area.bound > more * scale * diameter->max + filter::underflow;
  return exceeds && diameter->min > 0x1p-400 ? std::optional(true) : std::nullopt;
}

/// Returns the contact point of docs/contact-rule.md#hidden-axes. Its bound is not
/// finite if there is none in the range of doubles.
inline Place contact_point(const PolygonAxis& axis, const Line& e, Continues which) {
  const Vec2& corner = axis.other[static_cast<std::size_t>(axis.corner)];
  if (which == Continues::other && axis.facing < 0)
    return {corner};
  const auto clamped = [](const Foot& foot) {
    return std::max(0.0, std::min(1.0, foot.value));
  };
  if (axis.facing < 0) {
    const Foot foot = foot_on(e, corner);
    return place_on(e, {clamped(foot), foot.bound});
  }
  const Line f = line_of(axis.other, axis.facing);
  const Foot high = foot_on(e, f.start), low = foot_on(e, f.end);
  const double at = 0.5 * (clamped(low) + clamped(high)),
               bound = low.bound + high.bound + filter::u8;
  if (which == Continues::own)
    return place_on(e, {at, bound});
  // The quotient of two differences.
  const double length = high.value - low.value, on_f = (high.value - at) / length;
  const double of_length = bound + filter::u8 * std::abs(length),
               of_part = bound + filter::u8 * (std::abs(high.value) + 1.0);
  return place_on(f, {on_f, 2.0 * (of_part + std::abs(on_f) * of_length) /
                                std::max(0.0, std::abs(length) - 2.0 * of_length)});
}

/// Tells whether a third polygon is certainly farther from the contact point than the
/// width of the widest joint: the point is so far outside one of its sides. The
/// question is the second condition of docs/contact-rule.md#hidden-axes.
inline bool is_remote(const PolygonAxis& axis, Outline third, Continues which) {
  const Line e = line_of(axis.own, axis.side);
  const double longest2 = std::min(longest_side2(axis.own), longest_side2(axis.other));
  if (!is_moderate(e.length2) || !is_moderate(longest2))
    return false;
  const double width = more * (widest_joint * std::sqrt(longest2));
  const Place place = contact_point(axis, e, which);
  return !all_sides(third, [&](const Line& side) {
    const Estimate area = side.area(place.point);
    const Vec2 along = side.end - side.start;
    const double size = std::abs(along.x()) + std::abs(along.y());
    return !is_moderate(side.length2) ||
           !(area.value + area.bound + 2.0 * place.bound * size <
             -more * (width * std::sqrt(side.length2)));
  });
}

}  // namespace blocks::geometry::quick
