#include "model/settings.hpp"

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
  const double left = gravity_ramp.begin + gravity_ramp.duration - time;
  if (!(left > 0.0))
    return gravity;
  return gravity - (left / gravity_ramp.duration) * (gravity - gravity_ramp.from);
}

}  // namespace blocks
