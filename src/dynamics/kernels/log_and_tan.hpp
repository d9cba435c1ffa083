// Logarithm and tangent for the law of Barton and Bandis. They consist of additions,
// multiplications, divisions and selections only, so that they give the same bits on
// every processor, and one number for each lane of a vector.
#pragma once

namespace blocks::dynamics {

/// The integers with as many bits as the numbers of a vector of doubles.
template <class Number> struct WholeOf { using type = decltype(Number{} < Number{}); };
template <> struct WholeOf<double> { using type = long long; };

/// A number x >= 1 as 2^exponent times a factor between sqrt(1/2) and sqrt(2).
template <class Number> struct Scaled {
  Number exponent;
  Number w;  ///< (factor - 1) / (factor + 1), |w| < 0.172
};
/// Returns the parts of x, 1 <= x < infinity.
template <class Number>
[[gnu::always_inline]] inline Scaled<Number> scaled(const Number& x) {
  using Whole = typename WholeOf<Number>::type;
  const Number none = Number{};
  const Whole bits = __builtin_bit_cast(Whole, x);
  // 2^52 + n has the bits of n in its last bits.
  const Number exponent =
      __builtin_bit_cast(Number, Whole((bits >> 52) | 0x4330000000000000)) -
      (0x1p52 + 1023.0);
  const Number factor =
      __builtin_bit_cast(Number, Whole((bits & 0xfffffffffffff) | 0x3ff0000000000000));
  const auto large = factor > 1.4142135623730951;
  const Number half = 0.5 * factor;
  const Number near = large ? half : factor;
  return {exponent + (large ? none + 1.0 : none), (near - 1.0) / (near + 1.0)};
}

/// Returns (artanh(w) - w) / w^3 for |w| < 0.172. The error of the truncated series is
/// below 2^-55 of artanh(w).
template <class Number>
[[gnu::always_inline]] inline Number artanh_rest(const Number& w) {
  const Number z = w * w;
  Number sum = z * (1.0 / 21.0) + 1.0 / 19.0;
  sum = sum * z + 1.0 / 17.0;
  sum = sum * z + 1.0 / 15.0;
  sum = sum * z + 1.0 / 13.0;
  sum = sum * z + 1.0 / 11.0;
  sum = sum * z + 1.0 / 9.0;
  sum = sum * z + 1.0 / 7.0;
  sum = sum * z + 1.0 / 5.0;
  sum = sum * z + 1.0 / 3.0;
  return sum;
}

/// Returns the decimal logarithm of x, 1 <= x < infinity, with a relative error below
/// 2^-50.
template <class Number> [[gnu::always_inline]] inline Number log10_of(const Number& x) {
  constexpr double log10_2 = 0.30102999566398119521,
                   two_over_ln10 = 0.86858896380650365530;
  const Scaled<Number> parts = scaled(x);
  const Number artanh = parts.w + parts.w * (parts.w * parts.w) * artanh_rest(parts.w);
  return parts.exponent * log10_2 + two_over_ln10 * artanh;
}

/// Returns ln(1 + x) - x / (1 + x) for 0 <= x < infinity, which is x^2 / 2 for small x,
/// with a relative error below 2^-47.
template <class Number>
[[gnu::always_inline]] inline Number closure_integral(const Number& x) {
  constexpr double ln_2 = 0.69314718055994530942;
  const Number sum = 1.0 + x;
  const Scaled<Number> parts = scaled(sum);
  // Below sqrt(2) the two first-order terms cancel, and are left out.
  const Number small = x / (2.0 + x);
  const Number w = parts.exponent > 0.0 ? parts.w : small;
  const Number rest = w * (w * w) * artanh_rest(w);
  const Number near = 2.0 * (w * w / (1.0 + w) + rest);
  const Number far = (parts.exponent * ln_2 + 2.0 * (w + rest)) - x / sum;
  return parts.exponent > 0.0 ? far : near;
}

/// The tangent of an angle of 0 to 0.62 as a fraction: Lambert's continued fraction up
/// to its eighth level. The error is below 2^-56 of the tangent.
template <class Number> struct Tangent { Number numerator, denominator; };
template <class Number>
[[gnu::always_inline]] inline Tangent<Number> tangent_of(const Number& y) {
  const Number z = y * y;
  return {y * (2027025.0 - z * (270270.0 - z * (6930.0 - z * 36.0))),
          2027025.0 - z * (945945.0 - z * (51975.0 - z * (630.0 - z)))};
}
/// Returns tan(y) for 0 <= y <= 0.62, with a relative error below 2^-50.
template <class Number>
[[gnu::always_inline]] inline Number small_tan(const Number& y) {
  const Tangent<Number> tangent = tangent_of(y);
  return tangent.numerator / tangent.denominator;
}
/// Returns tan(x) for 0 <= x <= 1.24 (71 degrees), with a relative error below 2^-49.
template <class Number> [[gnu::always_inline]] inline Number tan_of(const Number& x) {
  const Number y = 0.5 * x;
  const Tangent<Number> tangent = tangent_of(y);
  return 2.0 * tangent.numerator * tangent.denominator /
         (tangent.denominator * tangent.denominator -
          tangent.numerator * tangent.numerator);
}

}  // namespace blocks::dynamics
