// How the values of many blocks or contacts are reduced to one.
#pragma once

#include <span>
#include <string>

namespace blocks::quantities {

struct Statistic {
  enum class How { sum, mean, smallest, largest, percentile };
  How how = How::mean;
  double percent = 0.0;  ///< of a percentile, 0 to 100

  bool operator==(const Statistic&) const = default;
  /// As the user writes it: "mean", "p90".
  std::string name() const;
  /// Reads "sum", "mean", "min", "max", or "p" and a number from 0 to 100, in any case.
  /// Returns false if it is none of them.
  static bool parse(const std::string& text, Statistic& statistic);
};

/// Returns the statistic of at least one value; NaN if one of them is NaN. Sums are
/// taken in the order of the values. A percentile p of n values in ascending order is
/// at the index p / 100 (n - 1), with linear interpolation between two values. The
/// values are reordered if the statistic is a percentile.
double reduce(const Statistic& statistic, std::span<double> values);

}  // namespace blocks::quantities
