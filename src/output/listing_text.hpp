// Pieces of fixed-width text shared by the parts of the listing: 132 columns, as
// printers had. No clock, no folder names: two equal runs print equal listings.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "model/blocks.hpp"

namespace blocks::output {

/// Nine digits, a sign, an exponent of three digits and a space between.
inline std::string number(double value) { return fmt::format("{:>17.9g}", value); }
inline std::string whole(long value) { return fmt::format("{:>9}", value); }

inline std::string heading(std::string_view text) {
  return fmt::format("\n{}\n{:-<{}}\n", text, "", text.size());
}

/// One column title, as wide as number() or whole().
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
  }
  return "        ?";
}

}  // namespace blocks::output
