#include "draw/number_text.hpp"

#include <array>
#include <cctype>
#include <cstdlib>

namespace blocks::draw {

std::string with_minus_signs(const std::string& words) {
  const auto is_digit = [&](std::size_t i) {
    return i < words.size() && std::isdigit(static_cast<unsigned char>(words[i])) != 0;
  };
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool begins = i == 0 || words[i - 1] == ' ' || words[i - 1] == '(' ||
                        (words[i - 1] == 'e' && i > 1 && is_digit(i - 2));
    if (words[i] == '-' && begins && is_digit(i + 1))
      result += "−";
    else
      result += words[i];
  }
  return result;
}

std::string superscript(int number) {
  static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴",
                                                         "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number)))
    text += digits.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

std::string with_unit(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " [" + unit + "]";
}

}  // namespace blocks::draw
