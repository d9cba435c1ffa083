// Fixed-width text shared by the parts of the listing, 132 columns wide as on line
// printers. It contains no times or folder names, so that identical runs print
// identical listings.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "model/blocks.hpp"

namespace blocks::output {

/// Nine digits. The width leaves space for a sign, a three-digit exponent and a space.
inline std::string number(double value) { return fmt::format("{:>17.9g}", value); }
inline std::string whole(long value) { return fmt::format("{:>9}", value); }

inline std::string heading(std::string_view text) {
  return fmt::format("\n{}\n{:-<{}}\n", text, "", text.size());
}

/// A column title, as wide as number() or whole().
inline std::string over_number(std::string_view title) {
  return fmt::format("{:>17}", title);
}
inline std::string over_whole(std::string_view title) {
  return fmt::format("{:>9}", title);
}

inline std::string fixity_word(Fixity fixity) {
  switch (fixity) {
  case Fixity::free:
    return "     free";
  case Fixity::by_user:
    return "    fixed";
  case Fixity::left_domain:
    return "     left";
  case Fixity::removed:
    return "  removed";
  case Fixity::driven:
    return "   driven";
  }
  return "        ?";
}

}  // namespace blocks::output
