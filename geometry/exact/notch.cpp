// Plain doubles decide first. Their error bounds are large multiples of the rounding
// errors, because few corners come near these limits (docs/predicates.md#overlap-region-and-notches).
#include "geometry/notch.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "geometry/exact/sides.hpp"

namespace blocks::geometry {
namespace {

using exact::Rational;

/// Part of the sum of the magnitudes of all terms that bounds their rounding errors.
constexpr double rounding = 0x1p-44;
/// If no difference of coordinates is larger than `largest`, what underflow loses in
/// products of four of them is less than `underflow`.
constexpr double largest = 0x1p300, underflow = 0x1p-400;

double magnitude(double x) { return std::abs(x); }
Rational magnitude(const Rational& x) { return x < 0 ? Rational(-x) : x; }

/// The larger of two numbers.
template <class Number> Number larger(const Number& a, const Number& b) {
  return a < b ? b : a;
}

/// A number and the sum of the magnitudes of the terms that it consists of.
template <class Number> struct Sum {
  Number value, terms;
  Sum(Number v, Number t) : value(v), terms(t) {}
  explicit Sum(Number v) : value(v), terms(magnitude(v)) {}
  Sum operator+(const Sum& o) const { return {value + o.value, terms + o.terms}; }
  Sum operator-(const Sum& o) const { return {value - o.value, terms + o.terms}; }
  Sum operator*(const Sum& o) const { return {value * o.value, terms * o.terms}; }
  Sum operator-() const { return {-value, terms}; }
};

template <class Number> struct Arrow {
  Sum<Number> x, y;
  Arrow(const Sum<Number>& along_x, const Sum<Number>& along_y)
      : x(along_x), y(along_y) {}
  /// A difference of two doubles has a rounding error of one unit only.
  Arrow(const Vec2& from, const Vec2& to)
      : x(Number(to.x()) - Number(from.x())), y(Number(to.y()) - Number(from.y())) {}
  Arrow left() const { return {-y, x}; }
};
template <class Number>
Sum<Number> cross(const Arrow<Number>& a, const Arrow<Number>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class Number>
Sum<Number> dot(const Arrow<Number>& a, const Arrow<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

/// A side and the foot of a corner on its line, in units of 1 / |e| along the side e.
template <class Number> struct Foot {
  Arrow<Number> e, to_corner;
  Sum<Number> square, at;  ///< e . e, (c - p1) . e
  Foot(const Vec2& c, const Vec2& p1, const Vec2& p2)
      : e(p1, p2), to_corner(p1, c), square(dot(e, e)), at(dot(to_corner, e)) {}
  /// Returns how far the foot is beyond the nearer end; negative: between the ends.
  Sum<Number> beyond() const {
    return {larger<Number>(-at.value, at.value - square.value),
            at.terms + square.terms};
  }
  Sum<Number> rise() const { return Sum<Number>(Number(notch_slope)) * beyond(); }
};

/// Returns 2A - notch_slope b, where b is the distance beyond the end times |e|.
template <class Number>
Sum<Number> reach_of(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const Foot<Number> foot(c, p1, p2);
  return cross(foot.to_corner, foot.e) - foot.rise();
}

/// Returns twice the area of the triangle of a polygon's side and the raised foot,
/// times e . e.
template <class Number>
Sum<Number> area_of(const Foot<Number>& foot, const Vec2& p1, const Vec2& start,
                    const Vec2& end) {
  const Arrow<Number> line(start, end);
  return foot.square * cross(Arrow<Number>(start, p1), line) +
         foot.at * cross(foot.e, line) + foot.rise() * cross(foot.e.left(), line);
}

/// Returns whether all differences of coordinates to a point are small enough.
bool are_moderate(const Vec2& from, std::initializer_list<Vec2> points) {
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
    return (p - from).lpNorm<Eigen::Infinity>() < 0.5 * largest;
  });
}

/// Returns the sign of a sum in doubles, or 0 if it is uncertain.
int sure_sign(const Sum<double>& sum) {
  const double bound = rounding * sum.terms + underflow;
  return sum.value > bound ? 1 : sum.value < -bound ? -1 : 0;
}

int sign(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

bool is_near_ends(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  if (are_moderate(p1, {c, p2}))
    if (const int sure = sure_sign(reach_of<double>(c, p1, p2)))
      return sure > 0;
  return reach_of<Rational>(c, p1, p2).value >= 0;
}

bool is_raised_foot_inside(const Vec2& c, const Vec2& p1, const Vec2& p2,
                           Outline polygon) {
  const Foot<double> foot(c, p1, p2);
  const auto is_inside = [&](int side) {
    const Vec2 &start = sides::start_of(polygon, side),
               &end = sides::end_of(polygon, side);
    if (are_moderate(p1, {c, p2, start, end}))
      if (const int sure = sure_sign(area_of<double>(foot, p1, start, end)))
        return sure > 0;
    return sign(area_of<Rational>(Foot<Rational>(c, p1, p2), p1, start, end).value) > 0;
  };
  for (int side = 0; side < static_cast<int>(polygon.size()); ++side)
    if (!is_inside(side))
      return false;
  return true;
}

}  // namespace blocks::geometry
