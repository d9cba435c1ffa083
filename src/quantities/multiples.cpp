#include "quantities/multiples.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

#include "geometry/decimal.hpp"

namespace blocks::quantities {

Multiples::Multiples(double interval) : interval_(interval) {
  const auto decimal = geometry::Decimal::parse(fmt::format("{}", interval));
  digits_ = std::stol(decimal->digits());
  exponent_ = decimal->exponent();
}

double Multiples::at(long k) const {
  const double rough = static_cast<double>(k) * interval_;
  if (std::abs(static_cast<double>(k) * static_cast<double>(digits_)) > 1e18)
    return rough;
  char text[64];
  const auto end =
      fmt::format_to_n(text, std::size(text), "{}e{}", k * digits_, exponent_).out;
  double value = rough;
  std::from_chars(text, end, value);
  return value;
}

long Multiples::first_from(double time) const {
  auto k = static_cast<long>(std::floor(time / interval_));
  while (at(k) < time - slack())
    ++k;
  return k;
}

}  // namespace blocks::quantities
