#include "report/sobol_indices.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace blocks::report {
namespace {

/// More samples would change the ends of an interval by less than a twentieth of its
/// width; fewer make it noisy.
constexpr int bootstrap_samples = 1000;

/// The products of one row whose means give the indices; f is measured from its mean.
struct RowTerms {
  double sum = 0.0, squares = 0.0;            ///< of f(a) and f(b)
  std::vector<double> d, b_times_d, d_twice;  ///< (parameters) d_i, f(b) d_i, d_i^2
};

bool is_finite(const SobolRow& row) {
  return std::isfinite(row.a) && std::isfinite(row.b) &&
         std::all_of(row.mixed.begin(), row.mixed.end(),
                     [](double value) { return std::isfinite(value); });
}

std::vector<RowTerms> terms_of(const std::vector<SobolRow>& rows) {
  double mean = 0.0;
  for (const SobolRow& row : rows)
    mean += 0.5 * (row.a + row.b) / static_cast<double>(rows.size());
  std::vector<RowTerms> terms;
  for (const SobolRow& row : rows) {
    const double a = row.a - mean, b = row.b - mean;
    RowTerms one{a + b, a * a + b * b, {}, {}, {}};
    for (const double mixed : row.mixed) {
      const double d = mixed - row.a;
      one.d.push_back(d);
      one.b_times_d.push_back(b * d);
      one.d_twice.push_back(d * d);
    }
    terms.push_back(std::move(one));
  }
  return terms;
}

/// The sums of the terms of some rows.
class Sums {
 public:
  explicit Sums(std::size_t parameters)
      : d_(parameters), b_times_d_(parameters), d_twice_(parameters) {}

  void add(const RowTerms& row) {
    ++rows_;
    sum_ += row.sum;
    squares_ += row.squares;
    for (std::size_t i = 0; i < d_.size(); ++i) {
      d_[i] += row.d[i];
      b_times_d_[i] += row.b_times_d[i];
      d_twice_[i] += row.d_twice[i];
    }
  }
  double first(std::size_t i) const {
    return (b_times_d_[i] - mean() * d_[i]) / (n() * variance());
  }
  double total(std::size_t i) const { return d_twice_[i] / (2.0 * n() * variance()); }
  double variance() const { return 0.5 * squares_ / n() - mean() * mean(); }

 private:
  double n() const { return static_cast<double>(rows_); }
  double mean() const { return 0.5 * sum_ / n(); }

  std::size_t rows_ = 0;
  double sum_ = 0.0, squares_ = 0.0;
  std::vector<double> d_, b_times_d_, d_twice_;
};

/// Returns whether f is not the same at all points a and b.
bool has_variance(const std::vector<SobolRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const SobolRow& row) {
    return row.a != rows.front().a || row.b != rows.front().a;
  });
}

/// Returns the middle 95 % of the values that are finite.
Interval middle_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  return {sorted_quantile(values, 0.5 * (1.0 - confidence)),
          sorted_quantile(values, 0.5 * (1.0 + confidence))};
}

void set_intervals(const std::vector<RowTerms>& terms,
                   std::vector<SobolIndex>& parameters) {
  std::vector<std::vector<double>> first(parameters.size()), total(parameters.size());
  std::mt19937_64 random;  // the standard defines its numbers
  for (int sample = 0; sample < bootstrap_samples; ++sample) {
    Sums sums(parameters.size());
    for (std::size_t j = 0; j < terms.size(); ++j)
      sums.add(terms[(random() >> 32) * terms.size() >> 32]);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      first[i].push_back(sums.first(i));
      total[i].push_back(sums.total(i));
    }
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    parameters[i].first_interval = middle_of(std::move(first[i]));
    parameters[i].total_interval = middle_of(std::move(total[i]));
  }
}

}  // namespace

SobolIndices sobol_indices(const std::vector<SobolRow>& rows) {
  SobolIndices found;
  std::vector<SobolRow> complete;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(complete), is_finite);
  found.rows = complete.size();
  found.left_out = rows.size() - complete.size();
  const std::size_t parameters = rows.empty() ? 0 : rows.front().mixed.size();
  if (std::any_of(rows.begin(), rows.end(),
                  [&](const SobolRow& row) { return row.mixed.size() != parameters; }))
    throw std::invalid_argument("rows have different numbers of parameters");
  found.parameters.resize(parameters);
  if (complete.size() < 2 || !has_variance(complete))
    return found;
  const std::vector<RowTerms> terms = terms_of(complete);
  Sums sums(parameters);
  for (const RowTerms& row : terms)
    sums.add(row);
  for (std::size_t i = 0; i < parameters; ++i) {
    found.parameters[i].first = sums.first(i);
    found.parameters[i].total = sums.total(i);
  }
  set_intervals(terms, found.parameters);
  return found;
}

}  // namespace blocks::report
