// Represents doubles as exact integers. Their differences, products and signs need no
// filter, error bound or rounding. Boost's integers are used, so that the audit shares
// no arithmetic with the CGAL numbers behind geometry/contact_predicates.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

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

inline Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Whole cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
inline Whole dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
inline int sign(const Whole& n) { return n.sign(); }

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

 private:
  int exponent_ = 0;  ///< exponent of the power of two
};

/// The double constant of a rule as an exact fraction, numerator / 2^shift.
struct Dyadic {
  Whole numerator;
  unsigned shift = 0;
  explicit Dyadic(double value);
};

}  // namespace blocks::audit
