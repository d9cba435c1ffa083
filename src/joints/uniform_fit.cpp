#include "joints/uniform_fit.hpp"

#include <algorithm>
#include <cmath>

namespace blocks::joints {
namespace {

/// A law on the grid, with the logarithm of its weight and then the weight.
struct Cell {
  double mean, half_range, weight;
};

/// Returns the quantiles of one coordinate.
Estimate quantiles(std::vector<Cell>& cells, double Cell::*coordinate) {
  std::sort(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) {
    return a.*coordinate < b.*coordinate;
  });
  double all = 0.0;
  for (const Cell& cell : cells)
    all += cell.weight;
  const auto quantile = [&](double probability) {
    double sum = 0.0;
    for (const Cell& cell : cells)
      if ((sum += cell.weight) >= probability * all)
        return cell.*coordinate;
    return cells.back().*coordinate;
  };
  constexpr double tail = 0.5 * (1.0 - confidence);
  return {quantile(0.5), quantile(tail), quantile(1.0 - tail)};
}

/// Returns distances from an end of the sample that grow as powers, with the widths of
/// their cells. unit: the usual distance; most: the largest one.
std::vector<std::pair<double, double>> distances(double unit, double max) {
  constexpr int count = 160;
  std::vector<std::pair<double, double>> found;
  if (!(max > 0.0))
    return {{0.0, 1.0}};
  const double step = std::log1p(max / unit) / count;
  for (int k = 0; k < count; ++k) {
    const double begin = unit * std::expm1(k * step);
    const double end = unit * std::expm1((k + 1) * step);
    found.emplace_back(0.5 * (begin + end), end - begin);
  }
  return found;
}

}  // namespace

UniformFit fit_uniform(const UniformSample& sample) {
  UniformFit fit;
  const std::vector<double>& values = sample.values;
  if (values.size() < 2)
    return fit;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double min = *low, max = *high, range = max - min;
  if (range <= sample.resolution) {
    const double middle = 0.5 * (min + max);
    fit.mean = {middle, middle - sample.resolution, middle + sample.resolution};
    fit.half_range = {0.0, 0.0, sample.resolution};
    fit.log_evidence = HUGE_VAL;
    return fit;
  }
  const auto n = static_cast<double>(values.size());
  // The probability that an end is farther away is below 1e-5.
  const double farthest = range * std::expm1(std::log(1e5) / (n - 1.0));
  const double below = std::min(farthest, min - sample.min);
  std::vector<Cell> cells;
  for (const auto& [p, dp] : distances(range / n, below))
    for (const auto& [q, dq] : distances(range / n, farthest)) {
      const double a = min - p, b = max + q;
      double likelihood = -n * std::log(b - a);
      if (sample.other_factors)
        likelihood += sample.other_factors(a, b);
      if (std::isfinite(likelihood))
        cells.push_back({0.5 * (a + b), 0.5 * (b - a), likelihood + std::log(dp * dq)});
    }
  if (cells.empty())
    return fit;
  double largest = -HUGE_VAL;
  for (const Cell& cell : cells)
    largest = std::max(largest, cell.weight);
  double evidence = 0.0;
  for (Cell& cell : cells) {
    cell.weight = std::exp(cell.weight - largest);
    // da db = 2 d mean d half_range, and the ratio has the factor 1 / mean.
    evidence += 0.5 * cell.weight / (cell.mean * cell.mean);
    cell.weight /= cell.half_range;
  }
  fit.log_evidence = largest + std::log(evidence);
  fit.mean = quantiles(cells, &Cell::mean);
  fit.half_range = quantiles(cells, &Cell::half_range);
  return fit;
}

}  // namespace blocks::joints
