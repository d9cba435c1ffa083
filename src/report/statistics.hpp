// Statistics of a sample of independent runs, with confidence intervals. Independent of
// files.
//
// The values of a sample are in the order of the seeds, so that the sums have the same
// bits however the runs were computed. A value that is not finite (a run without it)
// does not count. A result that does not exist, such as the standard deviation of one
// value, is NaN.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace blocks::report {

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The confidence of all intervals.
inline constexpr double confidence = 0.95;

struct Interval {
  double low = no_number, high = no_number;
};

/// Returns Wilson's score interval of the share k / n, 0 <= k <= n:
///
///     (k + z^2 / 2 -+ z sqrt(k (n - k) / n + z^2 / 4)) / (n + z^2)
///
/// z is the 97.5 % quantile of the normal distribution, 1.96. For k = 0 the interval is
/// from 0 to z^2 / (n + z^2). NaN if n is 0.
Interval wilson(std::size_t k, std::size_t n);

/// Returns the two-sided quantile of Student's distribution with n - 1 degrees of
/// freedom, P(|t| <= quantile) = confidence. NaN if n < 2.
double student_quantile(std::size_t n);

/// A quantile of the distribution from which a sample was drawn.
struct Quantile {
  double probability = 0.5;  ///< p, 0 < p < 1
  double value = no_number;  ///< the estimate
  /// Covers the quantile with at least the confidence, whatever the distribution. An
  /// end is NaN if the sample is too small for it.
  Interval interval;
};

/// Returns the estimate of quantile() alone.
double sorted_quantile(const std::vector<double>& ascending, double probability);

/// Returns the quantile p of values in ascending order, x_1 <= ... <= x_n. The estimate
/// is at the index h = 1 + p (n - 1), with linear interpolation between two values. The
/// number B of values below the quantile has the binomial distribution (n, p). The ends
/// of the interval are x_j and x_k, with the largest j for which P(B < j) <= 0.025, and
/// the smallest k for which P(B >= k) <= 0.025.
Quantile quantile(const std::vector<double>& ascending, double probability);

/// The summary of a sample x_1 ... x_n.
struct Summary {
  std::size_t n = 0;                      ///< finite values
  double mean = no_number;                ///< m = sum x / n
  double standard_deviation = no_number;  ///< s = sqrt(sum (x - m)^2 / (n - 1))
  /// m -+ t s / sqrt(n), t = student_quantile(n): covers the expectation with the
  /// confidence if the means of such samples are normally distributed.
  Interval mean_interval;
  Quantile low{0.05, no_number, {}}, median{0.5, no_number, {}},
      high{0.95, no_number, {}};
  double min = no_number, max = no_number;
  std::size_t min_at = 0, max_at = 0;  ///< indices in the sample, of the first ones
};

/// Computes mean and standard deviation in two passes: the second one sums the
/// differences from the mean of the first one, and corrects it.
Summary summarize(const std::vector<double>& values);

/// How narrow the t interval of a mean is to be.
struct Precision {
  double half_width = 0.05;  ///< > 0; in units of the quantity, or a part of |mean|
  bool relative = true;

  /// Reads "5%" or "0.01". Throws std::runtime_error.
  static Precision parse(const std::string& text);
  /// "5 %" or "0.01".
  std::string words() const;
};

/// Returns the smallest number of runs n >= 2 for which t s / sqrt(n) <= the half
/// width, if s and the mean remain those of the summary. Empty if there is no standard
/// deviation, if the half width is 0, or if more than 10^9 runs would be needed.
std::optional<std::size_t> needed_runs(const Summary& summary,
                                       const Precision& precision);

/// Returns the summary of the differences second[i] - first[i]. Both samples have the
/// same seeds; pairs with a value that is not finite do not count. The same random
/// numbers make the differences vary less than the values. Throws
/// std::invalid_argument if the samples have different lengths.
Summary paired_difference(const std::vector<double>& first,
                          const std::vector<double>& second);

}  // namespace blocks::report
