#include "geometry/overlap_region.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "geometry/exact/sides.hpp"

namespace blocks::geometry::exact {
namespace {

using sides::Interval;

/// A vertex of the overlap region.
template <class Number> struct Vertex { Number x, y; };

/// The square of the diameter of the overlap region. Intervals may leave open whether a
/// segment has a length, so there are bounds from the segments that certainly have one
/// and from those that may have one.
template <class Number> class Diameter {
 public:
  Diameter(Outline one, Outline other, std::span<const Vec2> joints) {
    add_segments(one, other);
    add_segments(other, one);
    for (const Vec2& joint : joints)
      add({Number(joint.x()), Number(joint.y())}, true);
  }
  /// Whether the region certainly has vertices, or may have some.
  bool has_vertices() const { return has_certain_; }
  bool may_have_vertices() const { return has_possible_; }
  const Number& low() const { return low_; }
  const Number& high() const { return high_; }

 private:
  void add_segments(Outline polygon, Outline other) {
    for (int i = 0; i < static_cast<int>(polygon.size()); ++i) {
      const auto segment = sides::part_in<Number>(polygon, i, other);
      if (segment.is_empty())
        continue;
      const bool is_certain = !segment.may_be_empty();
      has_possible_ = true;
      has_certain_ = has_certain_ || is_certain;
      const Vec2& start = sides::start_of(polygon, i);
      const sides::Vector<Number> along(start, sides::end_of(polygon, i));
      for (const Number& at : {segment.from, segment.to})
        add({Number(start.x()) + at * along.x, Number(start.y()) + at * along.y},
            is_certain);
    }
  }
  void add(const Vertex<Number>& vertex, bool is_certain) {
    for (const auto& [other, other_is_certain] : vertices_) {
      const Number x = other.x - vertex.x, y = other.y - vertex.y,
                   distance2 = x * x + y * y;
      high_ = sides::most(high_, distance2);
      if (is_certain && other_is_certain)
        low_ = sides::most(low_, distance2);
    }
    vertices_.emplace_back(vertex, is_certain);
  }

  std::vector<std::pair<Vertex<Number>, bool>> vertices_;
  Number low_ = Number(0), high_ = Number(0);
  bool has_certain_ = false, has_possible_ = false;
};

/// A corner and the line below which it is.
struct CornerBelow {
  const Vec2 &c, &p1, &p2;
};

/// Answers is_far(). Returns nothing if the number type cannot decide.
template <class Number>
std::optional<bool> find_far(const CornerBelow& corner, const CornerBelow& least_axis,
                             Outline one, Outline other, std::span<const Vec2> joints) {
  using Side = sides::Vector<Number>;
  const Side e(corner.p1, corner.p2), f(least_axis.p1, least_axis.p2);
  const Number square = dot(e, e);
  // The excess of the depth over the slack, times the length of the side.
  const Number excess =
      cross(Side(corner.p1, corner.c), e) - Number(contact_slack) * square;
  if (CGAL::certainly(excess <= 0))
    return false;
  if (!CGAL::certainly(excess > 0))
    return std::nullopt;
  const Number factor(far_factor);
  const Number least =
      factor * sides::most(cross(Side(least_axis.p1, least_axis.c), f), Number(0));
  const auto is_not_deeper = excess * excess * dot(f, f) <= least * least * square;
  if (CGAL::certainly(is_not_deeper))
    return false;
  const Diameter<Number> diameter(one, other, joints);
  const Number per_square = factor * factor * square;
  if (!diameter.may_have_vertices() ||
      (diameter.has_vertices() &&
       CGAL::certainly(excess * excess <= per_square * diameter.low())))
    return false;
  if (diameter.has_vertices() && CGAL::certainly(!is_not_deeper) &&
      CGAL::certainly(excess * excess > per_square * diameter.high()))
    return true;
  return std::nullopt;
}

std::optional<bool> find_far_by_intervals(const CornerBelow& corner,
                                          const CornerBelow& least_axis, Outline one,
                                          Outline other, std::span<const Vec2> joints) {
  const Interval::Protector upward;
  try {
    return find_far<Interval>(corner, least_axis, one, other, joints);
  } catch (const sides::Overflow&) {
    return std::nullopt;
  }
}

}  // namespace

bool is_far(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& d,
            const Vec2& q1, const Vec2& q2, Outline one, Outline other,
            std::span<const Vec2> joints) {
  const CornerBelow corner{c, p1, p2}, least_axis{d, q1, q2};
  if (const auto sure = find_far_by_intervals(corner, least_axis, one, other, joints))
    return *sure;
  return *find_far<Rational>(corner, least_axis, one, other, joints);
}

bool has_segment(Outline polygon, int side, Outline other) {
  return !sides::part_in<Rational>(polygon, side, other).is_empty();
}

}  // namespace blocks::geometry::exact
