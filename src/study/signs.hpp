// The predicates of the study's variants: in plain floating point, or exact with other
// limits of edges.
#pragma once

#include <cmath>

#include "dynamics/rules/predicates.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::study {

using geometry::Vec2;

/// The treatment of a corner on the limit of an edge: at its ends or on its line.
enum class Ends {
  strict,     ///< a corner on the limit is outside
  inclusive,  ///< a corner on the limit is inside
  slack       ///< inside up to 2^-18 of the edge's length beyond
};

/// Twice the area of (19) as printed, in absolute coordinates.
struct PrintedArea {
  using Number = double;
  static double twice(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return p1.x() * c.y() + c.x() * p2.y() + p2.x() * p1.y() - p1.y() * c.x() -
           c.y() * p2.x() - p2.y() * p1.x();
  }
};

/// The same in coordinates relative to the edge's first corner.
template <class Float> struct TranslatedArea {
  using Number = Float;
  static Float twice(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const Float x1 = p1.x(), y1 = p1.y();
    return (c.x() - x1) * (p2.y() - y1) - (c.y() - y1) * (p2.x() - x1);
  }
};

/// Predicates in plain floating point, without control of round-off. Only the questions
/// about third parts (geometry/continuation.hpp) are exact.
template <class Area, Ends ends> struct PlainSigns : dynamics::ExactPredicates {
  using Number = typename Area::Number;
  struct Vector {
    Number x, y;
    Vector(const Vec2& from, const Vec2& to)
        : x(Number(to.x()) - from.x()), y(Number(to.y()) - from.y()) {}
    Number dot(const Vector& o) const { return x * o.x + y * o.y; }
    Number cross(const Vector& o) const { return x * o.y - y * o.x; }
    Number length() const { return std::sqrt(dot(*this)); }
  };
  static bool in(Number distance, Number slack) {
    return ends == Ends::strict      ? distance > 0
           : ends == Ends::inclusive ? distance >= 0
                                     : distance + slack >= 0;
  }
  static int sign(Number value) { return int{value > 0} - int{value < 0}; }

  static int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return sign(Area::twice(c, p1, p2));
  }
  /// The error bound is 0, because plain floating point has none.
  static geometry::filter::Estimate depth(const Vec2& c, const Vec2& p1, const Vec2& p2,
                                          double) {
    return {static_cast<double>(Area::twice(c, p1, p2) / Vector(p1, p2).length()), 0.0};
  }
  static int depth_sign(const geometry::filter::Estimate&, const Vec2& c,
                        const Vec2& p1, const Vec2& p2) {
    return overlap_sign(c, p1, p2);
  }
  static bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const Vector e(p1, p2);
    return in(Area::twice(c, p1, p2), Number(geometry::contact_slack) * e.dot(e));
  }
  static bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return within_ends(c, p1, p2, Number(geometry::contact_slack));
  }
  /// Equation (20) for one tangent of a corner.
  static bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                         const Vec2& p2) {
    const Vector e(p1, p2), t(c, neighbour);
    return e.cross(t) / (e.length() * t.length()) >= -std::sin(facing_angle());
  }
  /// Equation (20) for two edges.
  static bool edges_face(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                         const Vec2& q2) {
    const Vector e(p1, p2), f(q1, q2);
    return e.dot(f) / (e.length() * f.length()) <= -std::cos(facing_angle());
  }
  static int turn_sign(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
    return sign(Vector(p1, p2).cross(Vector(q1, q2)));
  }
  static int compare_depths(const Vec2& c, const Vec2& p1, const Vec2& p2,
                            const Vec2& d, const Vec2& q1, const Vec2& q2) {
    return sign(Area::twice(c, p1, p2) / Vector(p1, p2).length() -
                Area::twice(d, q1, q2) / Vector(q1, q2).length());
  }
  static int compare_slopes(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                            const Vec2& q2, const Vec2& r1, const Vec2& r2) {
    const Vector p(p1, p2), q(q1, q2), r(r1, r2);
    return sign(std::abs(p.cross(q)) / q.length() - std::abs(p.cross(r)) / r.length());
  }

 private:
  static Number facing_angle() {
    return Number(geometry::facing_angle) * std::acos(Number(-1)) / 180;
  }
  static bool within_ends(const Vec2& c, const Vec2& p1, const Vec2& p2, Number part) {
    const Vector e(p1, p2);
    const Number along = Vector(p1, c).dot(e), square = e.dot(e);
    return in(along, part * square) && in(square - along, part * square);
  }
};

/// The same predicates, exact for the stored doubles. Without slack, `between` and
/// `well_between` are identical.
template <Ends ends> struct ExactSigns : dynamics::ExactPredicates {
  static int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return geometry::overlap_sign(c, p1, p2);
  }
  static bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                         const Vec2& p2) {
    return geometry::faces_edge(c, neighbour, p1, p2);
  }
  static bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    if constexpr (ends == Ends::slack)
      return geometry::near_or_inside(c, p1, p2);
    const int sign = geometry::overlap_sign(c, p1, p2);
    return ends == Ends::strict ? sign > 0 : sign >= 0;
  }
  static bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    if constexpr (ends == Ends::slack)
      return geometry::between(c, p1, p2);
    else if constexpr (ends == Ends::inclusive)
      return not_before(c, p1, p1, p2) && not_before(c, p2, p2, p1);
    else
      return !not_before(c, p1, p2, p1) && !not_before(c, p2, p1, p2);
  }

 private:
  /// Tests the sign of (c - o).(p2 - p1). turn_sign has that of (c - o) x (p2 - p1),
  /// and rotating p1 and p2 by a right angle is exact.
  static bool not_before(const Vec2& c, const Vec2& o, const Vec2& p1, const Vec2& p2) {
    return geometry::turn_sign(o, c, {-p2.y(), p2.x()}, {-p1.y(), p1.x()}) <= 0;
  }
};

}  // namespace blocks::study
