#include "model/safe_fraction.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/crack_report.hpp"

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

std::string limit_in_words(const TimeStep& step, const Settings& settings) {
  std::string text = limit_in_words(step);
  if (chooses_fraction(settings) && !step.elastic)
    text += ", largest safe step with " + damping_in_words(settings);
  return text;
}

std::string damping_in_words(const Settings& settings) {
  return fmt::format("DAMPING {:g}", settings.damping) +
         (settings.local_damping > 0.0
              ? fmt::format(" and LOCDAMP {:g}", settings.local_damping)
              : "");
}

}  // namespace blocks
