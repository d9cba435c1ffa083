// PRIVATE to geometry/: the two exact kernels. Filtered predicates decide about given
// doubles; plain rationals construct what the deck describes. Lazy numbers bring no
// advantage there, and long chains of them overflow the stack.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include "geometry/vec2.hpp"

namespace blocks::geometry::exact {

/// Exact predicates on doubles.
using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
inline Filtered::Point_2 point(const Vec2& p) { return {p.x(), p.y()}; }

/// Exact constructions.
using Rational = CGAL::Gmpq;
using Kernel = CGAL::Simple_cartesian<Rational>;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;

/// z component of a x b.
inline Rational cross(const Vector& a, const Vector& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace blocks::geometry::exact
