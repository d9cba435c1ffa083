// PRIVATE to geometry/: the rational coordinates that an ExactPoint holds.
#pragma once

#include <memory>

#include "geometry/cut.hpp"
#include "geometry/exact/kernels.hpp"
#include "geometry/exact/numbers.hpp"

namespace blocks::geometry::exact {

struct SharedPoint {
  Point point;
};

/// Returns the exact coordinates of a point.
inline Point point_of(const ExactPoint& p) {
  if (const SharedPoint* shared = p.rational())
    return shared->point;
  return {Rational(p.nearest().x()), Rational(p.nearest().y())};
}

/// Makes a point with these coordinates, which need not be doubles.
inline ExactPoint exact_point(const Point& p) {
  const Vec2 rounded = nearest(p);
  if (p.x() == Rational(rounded.x()) && p.y() == Rational(rounded.y()))
    return {rounded};
  return ExactPoint(std::make_shared<const SharedPoint>(SharedPoint{p}));
}

}  // namespace blocks::geometry::exact
