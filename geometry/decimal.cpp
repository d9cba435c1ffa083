#include "geometry/decimal.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace blocks::geometry {
namespace {

// The first significant digit must be within this many decades of the point. So no text
// of a deck represents a rational of a million digits.
constexpr long largest_decade = 400;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Returns the digits from `at` on and moves `at` behind them.
std::string_view take_digits(std::string_view text, std::size_t& at) {
  const std::size_t start = at;
  while (at < text.size() && is_digit(text[at]))
    ++at;
  return text.substr(start, at - start);
}

// Reads [+-]digits, clamped to +-10^9; larger exponents are legal only for the value
// zero.
std::optional<long> take_exponent(std::string_view text, std::size_t& at) {
  const bool negative = at < text.size() && text[at] == '-';
  if (at < text.size() && (text[at] == '-' || text[at] == '+'))
    ++at;
  const std::string_view digits = take_digits(text, at);
  if (digits.empty())
    return std::nullopt;
  long exponent = 0;
  for (const char c : digits)
    exponent = std::min(exponent * 10 + (c - '0'), 1000000000L);
  return negative ? -exponent : exponent;
}

// Reads a number without a sign, if the library knows its form.
std::optional<double> read_double(std::string_view text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return value;
}

// Returns the nearest double of digits * 10^exponent, or zero if it is too small.
double nearest_double(const std::string& digits, long exponent) {
  const std::string text = digits + "e" + std::to_string(exponent);
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc::result_out_of_range) {
    const long decade = exponent + static_cast<long>(digits.size());
    return decade > 0 ? HUGE_VAL : 0.0;
  }
  return value;
}

}  // namespace

Decimal::Decimal(int value) : digits_(std::to_string(value)), value_(value) {
  while (value != 0 && digits_.back() == '0') {
    digits_.pop_back();
    ++exponent_;
  }
}

std::optional<Decimal> Decimal::parse(std::string_view text) {
  std::size_t at = 0;
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+'))
    ++at;
  std::string digits(take_digits(text, at));
  long exponent = 0;
  if (at < text.size() && text[at] == '.') {
    const std::string_view fraction = take_digits(text, ++at);
    digits += fraction;
    exponent = -static_cast<long>(fraction.size());
  }
  if (digits.empty())
    return std::nullopt;
  if (at < text.size() && std::string_view("eEdD").find(text[at]) != text.npos) {
    const auto written = take_exponent(text, ++at);
    if (!written)
      return std::nullopt;
    exponent += *written;
  }
  if (at != text.size())
    return std::nullopt;

  // Each value has one form, without zeros at either end.
  const std::size_t first = digits.find_first_not_of('0');
  if (first == digits.npos)
    return Decimal();
  const std::size_t last = digits.find_last_not_of('0');
  exponent += static_cast<long>(digits.size() - 1 - last);
  digits = digits.substr(first, last - first + 1);
  const long decade = exponent + static_cast<long>(digits.size()) - 1;
  if (decade > largest_decade || decade < -largest_decade)
    return std::nullopt;

  Decimal decimal;
  decimal.exponent_ = exponent;
  const auto value = read_double(text.substr(text[0] == '-' || text[0] == '+' ? 1 : 0));
  decimal.value_ = value ? *value : nearest_double(digits, exponent);
  if (!std::isfinite(decimal.value_))
    return std::nullopt;
  if (negative && decimal.value_ != 0.0)
    decimal.value_ = -decimal.value_;
  if (negative)
    digits.insert(digits.begin(), '-');
  decimal.digits_ = std::move(digits);
  return decimal;
}

}  // namespace blocks::geometry
