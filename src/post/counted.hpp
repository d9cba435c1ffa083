// Returns a count with its noun: "1 picture", "3 pictures".
#pragma once

#include <cstddef>
#include <string>

namespace blocks::post {

inline std::string counted(std::size_t n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

}  // namespace blocks::post
