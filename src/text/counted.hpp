// A count with its noun.
#pragma once

#include <concepts>
#include <string>

namespace blocks {

/// Returns "1 block", "3 blocks".
std::string counted(std::integral auto n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

}  // namespace blocks
