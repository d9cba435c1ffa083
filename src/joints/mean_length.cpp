#include "joints/mean_length.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>

#include "geometry/polygon.hpp"
#include "geometry/random.hpp"
#include "joints/window.hpp"

namespace blocks::joints {
namespace {

/// Returns a Poisson number with mean 1 for a uniform number in [0, 1).
int poisson_of(double uniform) {
  double probability = std::exp(-1.0), sum = probability;
  int count = 0;
  while (uniform >= sum && count < 20)
    sum += probability /= ++count;
  return count;
}

struct Sums {
  double visible_ends = 0.0, hidden_ends = 0.0, length = 0.0;

  void add(const Piece& piece, double weight) {
    visible_ends += weight * (2 - piece.hidden);
    hidden_ends += weight * piece.hidden;
    length += weight * piece.length;
  }
};

/// The four quantities of TraceDensity.
std::vector<double> quantities(const Sums& sums, double area, double width) {
  return {0.5 * sums.visible_ends / area, sums.length / area,
          2.0 * sums.length / sums.visible_ends,
          area / width * sums.hidden_ends / sums.visible_ends};
}

/// The parts of the distribution beyond the interval.
constexpr double tail = 0.5 * (1.0 - confidence);

/// Returns the place of the least value of f in [low, high].
double place_of_minimum(const std::function<double(double)>& f, double low,
                        double high) {
  constexpr int bits = 24;  // of half of those of a double
  return boost::math::tools::brent_find_minima(f, low, high, bits).first;
}

/// Returns where f, which falls from the maximum at `peak` towards `end`, is 0; `end`
/// if it is nowhere.
double crossing(const std::function<double(double)>& f, double peak, double end) {
  if (f(end) > 0.0)
    return end;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (peak + end);
    (f(middle) > 0.0 ? peak : end) = middle;
  }
  return 0.5 * (peak + end);
}

}  // namespace

TraceDensity trace_density(const std::vector<Piece>& pieces,
                           const geometry::Polygon& window) {
  const double area = geometry::section_properties(window).area;
  double width = 0.0;
  Sums sums;
  for (const Piece& piece : pieces) {
    width += chord_measure(window, piece.direction).width;
    sums.add(piece, 1.0);
  }
  width /= static_cast<double>(std::max<std::size_t>(pieces.size(), 1));
  constexpr int resamples = 1000;
  constexpr geometry::StreamKey stream{20151982, 1};
  std::vector<std::vector<double>> found(4);
  for (int k = 0; k < resamples; ++k) {
    Sums resampled;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      resampled.add(pieces[i],
                    poisson_of(0x1p-53 * static_cast<double>(geometry::random_53_bits(
                                             stream, i, static_cast<unsigned>(k), 0))));
    const std::vector<double> values = quantities(resampled, area, width);
    for (std::size_t q = 0; q < values.size(); ++q)
      if (std::isfinite(values[q]))
        found[q].push_back(values[q]);
  }
  const std::vector<double> values = quantities(sums, area, width);
  std::vector<Estimate> estimates;
  for (std::size_t q = 0; q < values.size(); ++q) {
    Estimate one;
    if (std::isfinite(values[q])) {
      std::sort(found[q].begin(), found[q].end());
      const auto last = static_cast<double>(found[q].size()) - 1.0;
      one = {values[q], found[q][static_cast<std::size_t>(tail * last)],
             found[q][static_cast<std::size_t>(std::ceil((1.0 - tail) * last))]};
    }
    estimates.push_back(one);
  }
  return {estimates[0], estimates[1], estimates[2], estimates[3]};
}

FittedLaw fit_length_law(LengthForm form, const LengthSample& sample) {
  FittedLaw fitted;
  fitted.law.form = form;
  fitted.parameters = form == LengthForm::exponential ? 1 : 2;
  if (sample.complete.size() < 2)
    return fitted;
  double sum = 0.0, max = 0.0;
  for (const auto* lengths :
       {&sample.complete, &sample.one_hidden, &sample.both_hidden})
    for (const double length : *lengths) {
      sum += length;
      max = std::max(max, length);
    }
  const double usual = sum / static_cast<double>(sample.size());
  // The law of this mean that fits best, and minus its log likelihood.
  const auto law_at = [&](double log_mean) {
    LengthLaw law{form, std::exp(log_mean), 0.0};
    if (form == LengthForm::lognormal)
      law.spread = std::exp(place_of_minimum(
          [&](double log_spread) {
            law.spread = std::exp(log_spread);
            return -sample.log_likelihood(law);
          },
          std::log(0.02), std::log(5.0)));
    return law;
  };
  const auto cost = [&](double log_mean) {
    const double value = -sample.log_likelihood(law_at(log_mean));
    return std::isfinite(value) ? value : 1e300;
  };
  const double low = std::log(0.01 * usual), high = std::log(100.0 * max);
  const double best = place_of_minimum(cost, low, high);
  fitted.law = law_at(best);
  fitted.log_likelihood = sample.log_likelihood(fitted.law);
  constexpr double half_chi_square = 1.920729;  // 95 %, one degree of freedom
  const auto above = [&](double log_mean) {
    return half_chi_square - (cost(log_mean) + fitted.log_likelihood);
  };
  fitted.mean = {fitted.law.mean, std::exp(crossing(above, best, low)),
                 std::exp(crossing(above, best, high))};
  return fitted;
}

}  // namespace blocks::joints
