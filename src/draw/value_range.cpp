#include "draw/value_range.hpp"

#include <algorithm>
#include <cmath>

#include "draw/number_text.hpp"

namespace blocks::draw {

ValueRange ValueRange::of_decades(double min, double max, int decades) {
  const double top = std::ceil(std::log10(max));
  const double bottom = std::floor(std::log10(min));
  return {std::pow(10.0, std::clamp(bottom, top - decades, top - 1.0)),
          std::pow(10.0, top), true};
}

double ValueRange::place(double value) const {
  if (!logarithmic)
    return (value - low) / (high - low);
  return value > low ? std::log(value / low) / std::log(high / low) : 0.0;
}

TickLabels ValueRange::ticks(int count) const {
  if (!logarithmic)
    return label_ticks(low, high, count);
  constexpr double rounding = 1e-9;  // of log10 of a power of ten
  TickLabels marked;
  const int first = static_cast<int>(std::ceil(std::log10(low) - rounding)),
            last = static_cast<int>(std::floor(std::log10(high) + rounding));
  const int every = std::max(1, (last - first + count) / std::max(count, 1));
  for (int power = first; power <= last; power += every) {
    marked.ticks.push_back(std::pow(10.0, power));
    marked.labels.push_back("10" + superscript(power));
  }
  return marked;
}

}  // namespace blocks::draw
