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

/// A whole number, as leading * 2^exponent, rounded to 62 bits.
struct Leading {
  double leading = 0.0;
  int exponent = 0;
  explicit Leading(const Whole& n) {
    if (n == 0)
      return;
    Whole size = abs(n);
    exponent = std::max(0, static_cast<int>(msb(size)) - 62);
    size >>= exponent;
    leading = static_cast<double>(size.convert_to<std::int64_t>());
    leading = sign(n) < 0 ? -leading : leading;
  }
};

}  // namespace

std::weak_ordering Length::operator<=>(const Length& other) const {
  if (sign(n) != sign(other.n))
    return sign(n) <=> sign(other.n);
  return sign(n) * (n * n * other.d2).compare(other.n * other.n * d2) <=> 0;
}

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
  const Leading number(n);
  return std::ldexp(number.leading, number.exponent + power * exponent_);
}

double Lattice::rounded(const Length& length) const {
  const Leading n(length.n), d2(length.d2);
  const int odd = d2.exponent % 2;
  return std::ldexp(n.leading / std::sqrt(std::ldexp(d2.leading, odd)),
                    n.exponent - (d2.exponent - odd) / 2 + exponent_);
}

double rounded(const Ratio& ratio) {
  const Leading n(ratio.n), d(ratio.d);
  return std::ldexp(n.leading / d.leading, n.exponent - d.exponent);
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
