#include "post/page/view_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace blocks::post {
namespace {

constexpr double max_digits = 999999;

/// Powers of ten, converted from text as the browser does, so that both have the same
/// bits.
const std::array<double, 64>& tens() {
  static const auto powers = [] {
    std::array<double, 64> made{};
    for (std::size_t k = 0; k < made.size(); ++k)
      made[k] = std::strtod(fmt::format("1e{}", k).c_str(), nullptr);
    return made;
  }();
  return powers;
}
double ten(int power) { return tens()[static_cast<std::size_t>(std::abs(power))]; }

double shifted(double value, int power) {
  return power >= 0 ? value * ten(power) : value / ten(power);
}

/// Returns the predicted digits; 0 for values that are not finite, as on the page,
/// which has no power of ten for them.
std::int64_t in_digits(double guess, int power) {
  if (power == not_finite)
    return 0;
  const double digits = std::floor(shifted(guess, -power) + 0.5);
  return std::isnan(digits)
             ? 0
             : static_cast<std::int64_t>(std::clamp(digits, -max_digits, max_digits));
}

}  // namespace

SixDigits six_digits_of(double value) {
  if (!std::isfinite(value) || std::abs(value) > FLT_MAX)
    return {std::isnan(value) ? 0 : value > 0 ? 1 : -1, not_finite};
  if (std::abs(value) < 1e-37)
    return {};
  std::array<char, 40> text{};  // "-1.23456e-07"
  const auto end = fmt::format_to_n(text.data(), text.size(), "{:.5e}", value).out;
  const char* at = text.data();
  const bool minus = *at == '-';
  at += minus ? 1 : 0;
  int digits = *at - '0', power = 0;
  for (int k = 2; k < 7; ++k)
    digits = 10 * digits + (at[k] - '0');
  at += at[8] == '+' ? 9 : 8;
  std::from_chars(at, end, power);
  return {minus ? -digits : digits, power - 5};
}

float float_of(const SixDigits& number) {
  if (number.power == not_finite)
    return number.digits == 0 ? std::numeric_limits<float>::quiet_NaN()
                              : static_cast<float>(number.digits) *
                                    std::numeric_limits<float>::infinity();
  return static_cast<float>(shifted(number.digits, number.power));
}

void DigitColumn::add(double value) {
  SixDigits digits = six_digits_of(value);
  if (digits.digits == 0 && digits.power != not_finite && exact.size() >= rows)
    if (const int before = exact[exact.size() - rows].power; before != not_finite)
      digits.power = before;
  exact.push_back(digits);
  shown.push_back(float_of(exact.back()));
}

Guess TimeGuess::of(const DigitColumn& column) const {
  return [&shown = column.shown, rows = column.rows,
          far = linear](std::size_t i) -> double {
    if (i < rows)
      return 0.0;
    const double before = shown[i - rows];
    return far && i >= 2 * rows ? 2 * before - static_cast<double>(shown[i - 2 * rows])
                                : before;
  };
}

std::uint32_t folded(std::int64_t value) {
  return static_cast<std::uint32_t>(value < 0 ? -2 * value - 1 : 2 * value);
}

std::vector<std::uint32_t> differences(const DigitColumn& column, const Guess& guess) {
  std::vector<std::uint32_t> residual(column.exact.size());
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] =
        folded(column.exact[i].digits - in_digits(guess(i), column.exact[i].power));
  return residual;
}

TimeGuess better_guess(const DigitColumn& column) {
  const auto cost = [&](const TimeGuess& guess) {
    double bits = 0.0;
    for (const std::uint32_t residual : differences(column, guess.of(column)))
      bits += std::log2(1.0 + residual);
    return bits;
  };
  return {cost({true}) < cost({false})};
}

float four_digits(double value) {
  if (value == 0.0)
    return 0.0F;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
  return static_cast<float>(unit * std::round(value / unit));
}

}  // namespace blocks::post
