#include "report/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>

#include "text/number.hpp"

namespace blocks::report {
namespace {

constexpr double tail = 0.5 * (1.0 - confidence);
constexpr std::size_t max_needed = 1'000'000'000;

/// Returns the normal quantile of the confidence, 1.96.
double normal_quantile() {
  static const double z = boost::math::quantile(boost::math::normal(), 1.0 - tail);
  return z;
}

/// Returns the largest j from 0 to n for which P(B < j) <= tail, B binomial (n, p); 0
/// means that there is none.
std::size_t lower_rank(std::size_t n, double p) {
  const boost::math::binomial count(static_cast<double>(n), p);
  const auto fits = [&](std::size_t j) {
    return j == 0 || boost::math::cdf(count, static_cast<double>(j - 1)) <= tail;
  };
  std::size_t low = 0, high = n + 1;  // low fits, high does not
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

double at_rank(const std::vector<double>& ascending, std::size_t rank) {
  return rank == 0 || rank > ascending.size() ? no_number : ascending[rank - 1];
}

}  // namespace

Interval wilson(std::size_t k, std::size_t n) {
  if (n == 0)
    return {};
  const double z = normal_quantile(), z2 = z * z;
  const auto hits = static_cast<double>(k), all = static_cast<double>(n);
  const double root = z * std::sqrt(hits * (all - hits) / all + 0.25 * z2);
  return {k == 0 ? 0.0 : (hits + 0.5 * z2 - root) / (all + z2),
          k == n ? 1.0 : (hits + 0.5 * z2 + root) / (all + z2)};
}

double student_quantile(std::size_t n) {
  if (n < 2)
    return no_number;
  const boost::math::students_t t(static_cast<double>(n - 1));
  return boost::math::quantile(boost::math::complement(t, tail));
}

double sorted_quantile(const std::vector<double>& ascending, double probability) {
  const std::size_t n = ascending.size();
  if (n == 0)
    return no_number;
  const double at = probability * static_cast<double>(n - 1);
  const auto below = std::min(static_cast<std::size_t>(at), n - 1);
  return below + 1 == n ? ascending[below]
                        : std::lerp(ascending[below], ascending[below + 1],
                                    at - static_cast<double>(below));
}

Quantile quantile(const std::vector<double>& ascending, double probability) {
  const std::size_t n = ascending.size();
  if (n == 0)
    return {probability, no_number, {}};
  // The number of values above the quantile is binomial (n, 1 - p).
  const std::size_t from_top = lower_rank(n, 1.0 - probability);
  return {probability,
          sorted_quantile(ascending, probability),
          {at_rank(ascending, lower_rank(n, probability)),
           at_rank(ascending, from_top == 0 ? 0 : n + 1 - from_top)}};
}

Summary summarize(const std::vector<double>& values) {
  Summary summary;
  std::vector<double> finite;
  finite.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (!std::isfinite(value))
      continue;
    if (finite.empty() || value < summary.min)
      summary.min = value, summary.min_at = i;
    if (finite.empty() || value > summary.max)
      summary.max = value, summary.max_at = i;
    finite.push_back(value);
  }
  summary.n = finite.size();
  if (finite.empty())
    return summary;
  const auto n = static_cast<double>(finite.size());
  double sum = 0.0;
  for (const double value : finite)
    sum += value;
  const double first = sum / n;
  double differences = 0.0, squares = 0.0;
  for (const double value : finite) {
    const double difference = value - first;
    differences += difference;
    squares += difference * difference;
  }
  // The mean of equal values is that value.
  summary.mean = std::clamp(first + differences / n, summary.min, summary.max);
  if (finite.size() > 1) {
    const double variance = (squares - differences * differences / n) / (n - 1.0);
    summary.standard_deviation =
        summary.min == summary.max ? 0.0 : std::sqrt(std::max(variance, 0.0));
    const double half =
        student_quantile(finite.size()) * summary.standard_deviation / std::sqrt(n);
    summary.mean_interval = {summary.mean - half, summary.mean + half};
  }
  std::sort(finite.begin(), finite.end());
  for (Quantile* one : {&summary.low, &summary.median, &summary.high})
    *one = quantile(finite, one->probability);
  return summary;
}

Precision Precision::parse(const std::string& text) {
  Precision precision;
  std::string number = text;
  precision.relative = number.ends_with('%');
  if (precision.relative)
    number.pop_back();
  while (number.ends_with(' '))
    number.pop_back();
  precision.half_width = text::number_of<double>(number).value_or(0.0);
  if (precision.half_width <= 0.0)
    throw std::runtime_error("a precision is a number above 0, such as 0.01, or a part "
                             "of the mean, such as 5%, found '" +
                             text + "'");
  if (precision.relative)
    precision.half_width /= 100.0;
  return precision;
}

std::string Precision::words() const {
  return relative ? fmt::format("{:.6g} %", 100.0 * half_width)
                  : fmt::format("{:.6g}", half_width);
}

std::optional<std::size_t> needed_runs(const Summary& summary,
                                       const Precision& precision) {
  const double s = summary.standard_deviation;
  const double half =
      precision.half_width * (precision.relative ? std::abs(summary.mean) : 1.0);
  if (!std::isfinite(s) || !(half > 0.0))
    return std::nullopt;
  const auto enough = [&](std::size_t n) {
    return student_quantile(n) * s / std::sqrt(static_cast<double>(n)) <= half;
  };
  // Student's quantile is larger than the normal one, which gives a lower bound.
  const double bound = std::pow(normal_quantile() * s / half, 2);
  if (!(bound < static_cast<double>(max_needed)))
    return std::nullopt;
  std::size_t low = std::max<std::size_t>(static_cast<std::size_t>(bound), 2);
  if (enough(low) && low == 2)
    return low;
  low = std::max<std::size_t>(low, 3) - 1;
  std::size_t high = low + 1;
  while (!enough(high))
    high = low + 2 * (high - low);
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (enough(middle) ? high : low) = middle;
  }
  return high;
}

Summary paired_difference(const std::vector<double>& first,
                          const std::vector<double>& second) {
  if (first.size() != second.size())
    throw std::invalid_argument("paired samples have different lengths");
  std::vector<double> differences;
  differences.reserve(first.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    differences.push_back(second[i] - first[i]);
  return summarize(differences);
}

}  // namespace blocks::report
