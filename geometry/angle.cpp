#include "geometry/angle.hpp"

#include "geometry/exact/numbers.hpp"

namespace blocks::geometry {

double tangent_of_degrees(const Decimal& degrees) {
  return exact::tangent_of_degrees(exact::rational(degrees));
}

}  // namespace blocks::geometry
