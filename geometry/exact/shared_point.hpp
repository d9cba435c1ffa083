// PRIVATE to geometry/: the exact coordinates that an ExactPoint holds if they are not
// doubles.
#pragma once

#include <gmp.h>

#include <memory>

#include "geometry/cut.hpp"
#include "geometry/exact/kernels.hpp"
#include "geometry/exact/numbers.hpp"

namespace blocks::geometry::exact {

/// A view of packed coordinates x / x_unit, y / y_unit, which are reduced, with units
/// > 0. It is valid as long as the point.
struct Coordinates {
  explicit Coordinates(const unsigned long* packed);
  mpz_t x, x_unit, y, y_unit;  ///< read only; nothing is to be cleared
};

/// Packs the coordinates into one block of memory.
std::shared_ptr<const unsigned long[]> packed(const Point& p);

/// Returns the exact coordinates of a point.
Point point_of(const ExactPoint& p);

/// Makes a point with these coordinates, which need not be doubles.
ExactPoint exact_point(const Point& p);

/// Compares x, then y; negative if p is before q. Takes exact numbers only where the
/// nearest doubles are equal.
int compare(const ExactPoint& p, const ExactPoint& q);

}  // namespace blocks::geometry::exact
