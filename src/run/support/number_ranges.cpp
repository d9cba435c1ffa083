#include "run/support/number_ranges.hpp"

#include <fmt/format.h>

namespace blocks::run {

std::string number_ranges(const std::vector<int>& blocks) {
  constexpr int max_ranges = 8;
  std::string text;
  std::size_t i = 0;
  for (int ranges = 0; i < blocks.size() && ranges < max_ranges; ++ranges) {
    const int first = blocks[i];
    while (i + 1 < blocks.size() && blocks[i + 1] == blocks[i] + 1)
      ++i;
    text += (text.empty() ? "" : ", ") + std::to_string(first + 1);
    if (blocks[i] > first)
      text += " to " + std::to_string(blocks[i] + 1);
    ++i;
  }
  if (i < blocks.size())
    text += fmt::format(" and {} more", blocks.size() - i);
  return text;
}

std::string blocks_are(const std::vector<int>& blocks) {
  const bool one = blocks.size() == 1;
  return fmt::format("block{} {} {}", one ? "" : "s", number_ranges(blocks),
                     one ? "is" : "are");
}

}  // namespace blocks::run
