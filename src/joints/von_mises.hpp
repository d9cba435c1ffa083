// Functions of the von Mises law with the density exp(kappa cos(a - mean)) / (2 pi
// I0(kappa)).
#pragma once

namespace blocks::joints {

/// Returns ln I0(x) - x, x >= 0, to 2e-7.
double log_scaled_i0(double x);

/// Returns the mean resultant I1(x) / I0(x), x > 0, to 3e-8.
double mean_resultant(double x);

/// Returns the concentration kappa with this mean resultant, 0 <= r <= 1. It is at most
/// 3.3e5, because deviations of axes below a twentieth of a degree are not told apart.
double kappa_of(double r);

}  // namespace blocks::joints
