#include "model/safe_fraction.hpp"

#include <cmath>

namespace blocks {

double safe_fraction(double damping, double local_damping, double contacts) {
  const double n = contacts * (1.0 + local_damping);
  return (std::sqrt(1.0 + 3.0 * n * damping * damping) - damping * std::sqrt(3.0 * n)) /
         std::sqrt(6.0 * n);
}

double safe_fraction(const Settings& settings) {
  return safe_fraction(settings.damping, settings.local_damping);
}

double fraction_in_force(const Settings& settings) {
  return chooses_fraction(settings) ? safe_fraction(settings) : settings.fraction;
}

}  // namespace blocks
