// The multiples of an interval, as decimals.
#pragma once

namespace blocks::quantities {

class Multiples {
 public:
  /// The multiples of an interval > 0 whose decimal is the shortest that reads as it.
  explicit Multiples(double interval);

  /// Returns the double nearest to multiple k: the third multiple of 0.1 is 0.3, not
  /// 0.30000000000000004. If the decimal has more than 18 digits, returns k * interval.
  double at(long k) const;
  /// Returns the index of the first multiple that has not passed at this time.
  long first_from(double time) const;
  /// Whether multiple k has come at this time, except for the slack.
  bool has_come(long k, double time) const { return at(k) - slack() <= time; }
  /// A multiple counts as reached if the time falls short of it by this much: times are
  /// sums of time steps, which are rounded. A billionth of the interval.
  double slack() const { return 1e-9 * interval_; }

 private:
  double interval_;
  long digits_ = 0;  ///< the interval is digits_ * 10^exponent_
  long exponent_ = 0;
};

}  // namespace blocks::quantities
