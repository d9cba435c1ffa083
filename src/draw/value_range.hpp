// The range of the values that colours or an axis of a figure show, linear or
// logarithmic.
#pragma once

#include "draw/axes.hpp"

namespace blocks::draw {

struct ValueRange {
  double low = 0.0, high = 1.0;  ///< low < high
  bool logarithmic = false;      ///< places follow the logarithm; low > 0

  /// Returns a logarithmic range of whole decades that holds `min` and `max`, 0 <=
  /// least <= most, most > 0. It has at least one decade and at most `decades`: those
  /// below `max`.
  static ValueRange of_decades(double min, double max, int decades);

  /// Returns the place of a value in the range: 0 at `low`, 1 at `high`. Values
  /// below the low end of a logarithmic range have 0.
  double place(double value) const;
  /// Returns about `count` ticks; those of a logarithmic range are powers of ten.
  TickLabels ticks(int count) const;
};

}  // namespace blocks::draw
