// The tangent of an angle of the deck.
#pragma once

#include "geometry/decimal.hpp"

namespace blocks::geometry {

/// Returns the double nearest to the tangent of an angle in degrees, |angle| <= 89. The
/// result is the same on every machine.
double tangent_of_degrees(const Decimal& degrees);

}  // namespace blocks::geometry
