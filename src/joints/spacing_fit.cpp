#include "joints/spacing_fit.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "joints/uniform_fit.hpp"

namespace blocks::joints {

SpacingFit fit_spacing(const SpacingSample& sample) {
  SpacingFit fit;
  if (sample.tracks == 0)
    return fit;
  // Exponential spacings make a Poisson number of tracks. With the weight 1 / mean,
  // length / mean has the gamma distribution.
  const double n = sample.tracks;
  constexpr double tail = 0.5 * (1.0 - confidence);
  fit.mean = {sample.length / n,
              sample.length / boost::math::gamma_p_inv(n, 1.0 - tail),
              sample.length / boost::math::gamma_p_inv(n, tail)};
  const double log_evidence = boost::math::lgamma(n) - n * std::log(sample.length);
  UniformSample uniform;
  uniform.values = sample.spacings;
  uniform.resolution = sample.resolution;
  uniform.other_factors = [&](double a, double b) {
    // A line begins at any place between two tracks: density S(y) / mean of the first
    // distance, and S(z) for the last one.
    double sum = -sample.lines * std::log(0.5 * (a + b));
    for (const double y : sample.beyond)
      sum += y <= a ? 0.0 : y < b ? std::log((b - y) / (b - a)) : -HUGE_VAL;
    return sum;
  };
  const UniformFit other = fit_uniform(uniform);
  if (other.log_evidence > log_evidence) {
    fit.exponential = false;
    fit.mean = other.mean;
    fit.half_range = other.half_range;
  }
  return fit;
}

}  // namespace blocks::joints
