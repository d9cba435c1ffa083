#include "model/settings.hpp"

#include <algorithm>

namespace blocks {

using geometry::Vec2;

// Plane strain with nu = E/(2G) - 1
// (docs/theory.md#strain-rates-and-stress).
double Material::c11() const {
  const double e = youngs_modulus, g = shear_modulus;
  return g * (4.0 * g - e) / (3.0 * g - e);
}

double Material::c12() const {
  const double e = youngs_modulus, g = shear_modulus;
  return g * (e - 2.0 * g) / (3.0 * g - e);
}

Vec2 Settings::gravity_at(double time) const {
  const auto& [from, begin, duration] = gravity_ramp;
  const double left = begin + duration - time;
  if (!(duration > 0.0) || !(left > 0.0))
    return gravity;
  return gravity - std::min(1.0, left / duration) * (gravity - from);
}

}  // namespace blocks
