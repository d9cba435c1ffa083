// First-order and total Sobol indices with bootstrap intervals. Independent of files.
//
// The variance of f(x), x uniformly distributed in a box, is a sum of parts, each of
// which depends on some of the parameters. The first-order index S_i is the part of
// parameter i alone; the total index T_i that of all parts in which i occurs.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "report/statistics.hpp"

namespace blocks::report {

/// The values of f in one row of the design: at two independent points a and b, and for
/// each parameter i at the point a with the coordinate i of b.
struct SobolRow {
  double a = 0.0, b = 0.0;
  std::vector<double> mixed;  ///< (parameters)
};

struct SobolIndex {
  double first = no_number, total = no_number;
  Interval first_interval, total_interval;
};

struct SobolIndices {
  std::size_t rows = 0;      ///< those that count
  std::size_t left_out = 0;  ///< rows with a value that is not finite
  /// (parameters) NaN if fewer than two rows count or the variance is 0.
  std::vector<SobolIndex> parameters;
};

/// Returns the indices of the rows that have finite values only. With d_i = f(mixed_i)
/// - f(a), m and V the mean and the variance of f at all points a and b:
///
///     S_i = mean((f(b) - m) d_i) / V     (Saltelli et al. 2010, eq. (b) of table 2)
///     T_i = mean(d_i^2) / (2 V)          (Jansen 1999, eq. (f) of table 2)
///
/// The intervals are the 2.5 and 97.5 % quantiles of the indices of 1000 samples of the
/// rows, drawn with replacement; the draws are the same for the same number of rows.
/// Throws std::invalid_argument if rows have different numbers of parameters.
SobolIndices sobol_indices(const std::vector<SobolRow>& rows);

}  // namespace blocks::report
