#include "joints/direction_fit.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>

#include "joints/uniform_fit.hpp"

namespace blocks::joints {
namespace {

double half_turn(double degrees) {
  return degrees - 180.0 * std::round(degrees / 180.0);
}

}  // namespace

DirectionFit fit_directions(const std::vector<Piece>& pieces, double middle) {
  const auto n = static_cast<double>(pieces.size());
  UniformSample uniform;
  uniform.resolution = 1e-6;  // degrees
  uniform.min = -HUGE_VAL;
  double mean = 0.0, squares = 0.0, fourths = 0.0;
  for (const Piece& piece : pieces) {
    uniform.values.push_back(half_turn(piece.direction - middle));
    mean += uniform.values.back() / n;
  }
  double min = HUGE_VAL, max = -HUGE_VAL;
  for (const double one : uniform.values) {
    const double square = (one - mean) * (one - mean);
    squares += square / n, fourths += square * square / n;
    min = std::min(min, one), max = std::max(max, one);
  }
  DirectionFit found;
  const auto is_uniform = [&] {  // of two laws with two parameters, the likelier one
    return -n * std::log(max - min) >
           -0.5 * n * (1.0 + std::log(2.0 * std::numbers::pi * squares));
  };
  if (max - min <= uniform.resolution || is_uniform()) {
    const UniformFit fit = fit_uniform(uniform);
    found = {fit.mean, fit.half_range};
  } else if (pieces.size() > 2) {
    const double deviation = std::sqrt(squares * n / (n - 1.0));
    const double t = boost::math::quantile(boost::math::students_t(n - 1.0),
                                           0.5 * (1.0 + confidence));
    const double off = t * deviation / std::sqrt(n);
    found.mean = {mean, mean - off, mean + off};
    const double half = std::numbers::sqrt3 * deviation;
    const double error =
        0.5 * half * std::sqrt(std::max(fourths / (squares * squares) - 1.0, 0.0) / n);
    found.half_range = {half, std::max(half - t * error, 0.0), half + t * error};
  } else {
    found.mean = {mean, unknown, unknown};
    found.half_range = {0.0, 0.0, 0.0};
  }
  found.mean.value += middle, found.mean.low += middle, found.mean.high += middle;
  return found;
}

}  // namespace blocks::joints
