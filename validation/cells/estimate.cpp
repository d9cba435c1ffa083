#include "validation/cells/estimate.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace blocks::validation {
namespace {

/// Returns the value that |t| exceeds with this probability.
double two_sided(double probability, int count) {
  const boost::math::students_t law(count - 1);
  return quantile(complement(law, probability / 2.0));
}

}  // namespace

double Estimate::half_width(double level) const {
  return error * two_sided(1.0 - level, count);
}

Estimate jackknife(const std::vector<Sums>& samples, const Statistic& statistic) {
  Sums total = Sums::Zero(sum::count);
  for (const Sums& one : samples)
    total += one;
  const auto n = static_cast<double>(samples.size());
  double changes = 0.0, square = 0.0;
  const double all = statistic(total);
  for (const Sums& one : samples) {
    const double change = statistic(total - one) - all;
    changes += change;
    square += change * change;
  }
  Estimate result;
  result.value = all - (n - 1.0) * (changes / n);
  result.error = std::sqrt((n - 1.0) / n * (square - changes * changes / n));
  result.count = static_cast<int>(samples.size());
  return result;
}

double family_limit(double probability, int comparisons, int count) {
  return two_sided(probability / comparisons, count);
}

}  // namespace blocks::validation
