// Doubles as whole numbers, so that differences, products and signs of them are exact
// without filters, error bounds or rounding: boost's integers of any length, apart from
// CGAL's numbers behind geometry/contact_predicates, which they judge.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "geometry/vec2.hpp"

namespace blocks::audit {

/// Any length; up to 512 bits without asking for memory.
using Whole =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
                                      512, 0, boost::multiprecision::signed_magnitude,
                                      boost::multiprecision::unchecked>,
                                  boost::multiprecision::et_off>;

/// A point or vector, in units of a lattice.
struct Point {
  Whole x, y;
};

inline Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Whole cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
inline Whole dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
inline int sign(const Whole& n) { return n.sign(); }

/// A power of two small enough that all numbers shown to it are whole multiples of it.
class Lattice {
 public:
  /// x: finite.
  void include(double x);
  /// x in units of the lattice, exactly; x was included.
  Whole operator()(double x) const;
  Point operator()(const geometry::Vec2& p) const {
    return {(*this)(p.x()), (*this)(p.y())};
  }
  /// n in units of the lattice to this power, as a double within 2^-60 of its size.
  double rounded(const Whole& n, int power) const;

 private:
  int exponent_ = 0;  ///< of the power of two
};

/// numerator / 2^shift, exactly: a constant of the rules that is a double.
struct Dyadic {
  Whole numerator;
  unsigned shift = 0;
  explicit Dyadic(double value);
};

}  // namespace blocks::audit
