// Returns a count with its noun: "1 block", "3 blocks".
#pragma once

#include <concepts>
#include <string>

namespace blocks {

std::string counted(std::integral auto n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

}  // namespace blocks
