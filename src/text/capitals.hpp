// Words in capitals.
#pragma once

#include <string>
#include <string_view>

namespace blocks::text {

/// Returns the text in capitals (ASCII letters only).
std::string capitals(std::string_view text);

}  // namespace blocks::text
