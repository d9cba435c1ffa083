#include "joints/length_law.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "joints/window.hpp"

namespace blocks::joints {
namespace {

constexpr double minus_infinity = -std::numeric_limits<double>::infinity();

/// The normal distribution P(Z > z).
double upper_tail(double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); }

/// ln P(Z > z), also far in the tail, where the probability is not a double.
double log_upper_tail(double z) {
  if (z < 30.0)
    return std::log(upper_tail(z));
  return -0.5 * z * z - std::log(z * std::sqrt(2.0 * std::numbers::pi));
}

}  // namespace

double LengthLaw::log_density(double x) const {
  switch (form) {
  case LengthForm::exponential:
    return -x / mean - std::log(mean);
  case LengthForm::lognormal: {
    const double z = (std::log(x / mean) + 0.5 * spread * spread) / spread;
    return -0.5 * z * z - std::log(x * spread * std::sqrt(2.0 * std::numbers::pi));
  }
  case LengthForm::uniform:
    return std::abs(x - mean) <= spread ? -std::log(2.0 * spread) : minus_infinity;
  }
  return minus_infinity;
}

double LengthLaw::log_survival(double x) const {
  switch (form) {
  case LengthForm::exponential:
    return -x / mean;
  case LengthForm::lognormal:
    return x > 0.0
               ? log_upper_tail((std::log(x / mean) + 0.5 * spread * spread) / spread)
               : 0.0;
  case LengthForm::uniform:
    return x <= mean - spread  ? 0.0
           : x < mean + spread ? std::log((mean + spread - x) / (2.0 * spread))
                               : minus_infinity;
  }
  return minus_infinity;
}

double LengthLaw::log_excess(double x) const {
  switch (form) {
  case LengthForm::exponential:
    return std::log(mean) - x / mean;
  case LengthForm::lognormal: {
    if (!(x > 0.0))
      return std::log(mean);
    // E[max(X - x, 0)] as for an option in finance: mean N(-z + spread) - x N(-z).
    const double z = (std::log(x / mean) + 0.5 * spread * spread) / spread;
    const double excess = mean * upper_tail(z - spread) - x * upper_tail(z);
    if (excess > 1e-9 * mean)
      return std::log(excess);
    // Far in the tail, by the asymptotic ratio of excess and survival.
    return log_upper_tail(z) + std::log(x * spread / std::max(z, 1.0));
  }
  case LengthForm::uniform: {
    if (x <= mean - spread)
      return std::log(mean - x);
    const double left = mean + spread - x;
    return left > 0.0 ? std::log(left * left / (4.0 * spread)) : minus_infinity;
  }
  }
  return minus_infinity;
}

double LengthSample::log_likelihood(const LengthLaw& law) const {
  double sum = 0.0;
  for (const double x : complete)
    sum += law.log_density(x);
  for (const double y : one_hidden)
    sum += law.log_survival(y);
  for (const double z : both_hidden)
    sum += law.log_excess(z);
  const double expected = std::exp(law.log_survival(shortest)) * area +
                          std::exp(law.log_excess(shortest)) * width;
  return sum - static_cast<double>(size()) * std::log(expected);
}

LengthSample length_sample(const std::vector<Piece>& pieces,
                           const geometry::Polygon& window, double shortest) {
  LengthSample sample;
  sample.shortest = shortest;
  for (const Piece& piece : pieces) {
    if (piece.length < shortest)
      continue;
    (piece.hidden == 0   ? sample.complete
     : piece.hidden == 1 ? sample.one_hidden
                         : sample.both_hidden)
        .push_back(piece.length);
    const ChordMeasure chords = chord_measure(window, piece.direction, shortest);
    sample.area += chords.area;
    sample.width += chords.width;
  }
  if (sample.size() > 0) {
    sample.area /= static_cast<double>(sample.size());
    sample.width /= static_cast<double>(sample.size());
  }
  return sample;
}

}  // namespace blocks::joints
