// Represents doubles as exact integers, and positions and lengths by such integers. So
// nothing needs a filter, an error bound or rounding. Boost's integers are used, so
// that the audit shares no arithmetic with the CGAL numbers behind
// geometry/contact_predicates.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <compare>

#include "geometry/vec2.hpp"

namespace blocks::audit {

/// An integer of any length. Up to 512 bits it needs no heap memory.
using Whole =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
                                      512, 0, boost::multiprecision::signed_magnitude,
                                      boost::multiprecision::unchecked>,
                                  boost::multiprecision::et_off>;

/// A point or vector in units of a lattice.
struct Point {
  Whole x, y;
};

inline Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator*(const Whole& factor, const Point& p) {
  return {factor * p.x, factor * p.y};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Whole cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
inline Whole dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
inline int sign(const Whole& n) { return n.sign(); }
/// Returns the vector turned by a right angle anticlockwise: outwards from a side.
inline Point left_of(const Point& along) { return {-along.y, along.x}; }

/// The exact fraction n / d, d > 0, not reduced. It is a position along a side, in
/// units of the side's length.
struct Ratio {
  Whole n = 0, d = 1;
  Ratio operator-(const Ratio& other) const {
    return {n * other.d - other.n * d, d * other.d};
  }
  std::weak_ordering operator<=>(const Ratio& other) const {
    return (n * other.d).compare(other.n * d) <=> 0;
  }
};

/// The exact length n / sqrt(d2), in units of a lattice. A depth 2A / L is stored as 2A
/// and L^2, so that no root is taken.
struct Length {
  Whole n, d2;
  Length operator/(const Whole& scale) const { return {n, d2 * scale * scale}; }
  Length operator-() const { return {-n, d2}; }
  std::weak_ordering operator<=>(const Length& other) const;
};

/// Converts a fraction to a double, with a relative error of about 2^-52.
double rounded(const Ratio& ratio);

/// A power of two of which all included numbers are integer multiples.
class Lattice {
 public:
  /// Refines the lattice for x, which must be finite.
  void include(double x);
  /// Returns x in units of the lattice, exactly. x must have been included.
  Whole operator()(double x) const;
  Point operator()(const geometry::Vec2& p) const {
    return {(*this)(p.x()), (*this)(p.y())};
  }
  /// Converts n, in units of the lattice to the given power, to a double. The relative
  /// error is at most about 2^-53.
  double rounded(const Whole& n, int power) const;
  double rounded(const Length& length) const;

 private:
  int exponent_ = 0;  ///< exponent of the power of two
};

/// The double constant of a rule as an exact fraction, numerator / 2^shift.
struct Dyadic {
  Whole numerator;
  unsigned shift = 0;
  explicit Dyadic(double value);
  Length operator*(const Length& length) const {
    return {numerator * length.n, length.d2 << (2 * shift)};
  }
  Ratio operator*(const Ratio& ratio) const {
    return {numerator * ratio.n, ratio.d << shift};
  }
};

}  // namespace blocks::audit
