#include "model/settings.hpp"

namespace blocks {

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

}  // namespace blocks
