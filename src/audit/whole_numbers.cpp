#include "audit/whole_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace blocks::audit {
namespace {

/// x = mantissa * 2^exponent.
struct Parts {
  std::int64_t mantissa;
  int exponent;
  explicit Parts(double x) {
    const double fraction = std::frexp(x, &exponent);
    mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    exponent -= 53;
    while (mantissa != 0 && mantissa % 2 == 0)
      mantissa /= 2, ++exponent;
  }
};

}  // namespace

void Lattice::include(double x) {
  if (x != 0.0)
    exponent_ = std::min(exponent_, Parts(x).exponent);
}

Whole Lattice::operator()(double x) const {
  const Parts parts(x);
  if (parts.mantissa == 0)
    return 0;
  return Whole(parts.mantissa) << (parts.exponent - exponent_);
}

double Lattice::rounded(const Whole& n, int power) const {
  if (n == 0)
    return 0.0;
  Whole size = abs(n);
  const int surplus = std::max(0, static_cast<int>(msb(size)) - 62);
  size >>= surplus;
  const double leading = static_cast<double>(size.convert_to<std::int64_t>());
  return std::ldexp(sign(n) < 0 ? -leading : leading, surplus + power * exponent_);
}

Dyadic::Dyadic(double value) {
  const Parts parts(value);
  numerator = parts.mantissa;
  if (parts.exponent < 0)
    shift = static_cast<unsigned>(-parts.exponent);
  else
    numerator <<= parts.exponent;
}

}  // namespace blocks::audit
