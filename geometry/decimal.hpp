// A decimal number exactly as the user wrote it. Ties written in decimals are therefore
// decided as written, such as an aspect ratio of 0.2 or widths that add up to the line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace blocks::geometry {

/// An exact decimal number, digits * 10^exponent, with its nearest double.
class Decimal {
 public:
  /// Zero.
  Decimal() = default;

  /// A whole number.
  Decimal(int value);  // NOLINT(google-explicit-constructor): lets 0, 1 be decimals

  /// Reads [+-]digits[.digits][(e|E|d|D)[+-]digits] without anything before or after.
  /// Returns nothing for any other text and for a value beyond the range of finite
  /// doubles (about 1.8e308). A value too small for a double keeps its exact digits
  /// down to 1e-400; smaller ones are refused. So no deck can require a rational of a
  /// million digits. The digits have no zeros at either end, so equal values have equal
  /// digits.
  static std::optional<Decimal> parse(std::string_view text);

  /// The nearest double (round to nearest, ties to even).
  double value() const { return value_; }

  /// The significant digits with an optional sign and without a point, and the power of
  /// ten that scales them.
  const std::string& digits() const { return digits_; }
  long exponent() const { return exponent_; }

 private:
  std::string digits_ = "0";
  long exponent_ = 0;
  double value_ = 0.0;
};

/// A point of the deck, [L].
struct DecimalPoint {
  Decimal x;
  Decimal y;
};

}  // namespace blocks::geometry
