#include "joints/von_mises.hpp"

#include <algorithm>
#include <cmath>

namespace blocks::joints {
namespace {

// The standard deviation of an axis [radians] is 1 / (2 sqrt kappa).
constexpr double largest_kappa = 3.3e5;

}  // namespace

// ln I0(x) - x, to 2e-7 (Abramowitz and Stegun, 9.8.1 and 9.8.2).
double log_scaled_i0(double x) {
  if (x < 3.75) {
    const double t = (x / 3.75) * (x / 3.75);
    return std::log(
               1.0 +
               t * (3.5156229 +
                    t * (3.0899424 +
                         t * (1.2067492 +
                              t * (0.2659732 + t * (0.0360768 + t * 0.0045813)))))) -
           x;
  }
  const double t = 3.75 / x;
  const double p =
      0.39894228 +
      t * (0.01328592 +
           t * (0.00225319 +
                t * (-0.00157565 +
                     t * (0.00916281 +
                          t * (-0.02057706 +
                               t * (0.02635537 +
                                    t * (-0.01647633 + t * 0.00392377)))))));
  return std::log(p) - 0.5 * std::log(x);
}

// The mean resultant I1(x) / I0(x), by Gauss's continued fraction, or for large x by
// its asymptotic series, to 3e-8.
double mean_resultant(double x) {
  if (x > 50.0)
    return 1.0 - 0.5 / x - 0.125 / (x * x) - 0.125 / (x * x * x);
  double fraction = 0.0;
  for (int k = 15 + static_cast<int>(1.2 * x); k >= 1; --k)
    fraction = 1.0 / (2.0 * k / x + fraction);
  return fraction;
}

// Returns kappa with this mean resultant, 0 <= r <= 1: the approximation of Best and
// Fisher (1981), improved by Newton's method.
double kappa_of(double r) {
  if (!(r < 1.0) || 0.5 / (1.0 - r) > largest_kappa)
    return largest_kappa;
  if (r < 1e-8)
    return 2.0 * r;
  double kappa = r < 0.53   ? 2.0 * r + r * r * r + 5.0 / 6.0 * std::pow(r, 5.0)
                 : r < 0.85 ? -0.4 + 1.39 * r + 0.43 / (1.0 - r)
                            : 1.0 / (r * r * r - 4.0 * r * r + 3.0 * r);
  for (int i = 0; i < 4; ++i) {
    const double a = mean_resultant(kappa);
    const double slope = 1.0 - a / kappa - a * a;
    if (slope > 0.0)
      kappa = std::clamp(kappa - (a - r) / slope, 0.5 * kappa, 2.0 * kappa);
  }
  return std::min(kappa, largest_kappa);
}

}  // namespace blocks::joints
