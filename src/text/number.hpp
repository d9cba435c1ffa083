// Reads numbers that the user writes.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>

namespace blocks::text {

/// Returns the number that the whole text is: a whole number, or a finite one such as
/// -1e-3, without blanks or +. Nothing if it is none, or has too many digits.
template <class Number> std::optional<Number> number_of(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end)
    return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>)
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  else
    return value;
}

}  // namespace blocks::text
