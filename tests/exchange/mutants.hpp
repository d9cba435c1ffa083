// Random changes of a text, for tests of readers.
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace blocks::testing {

/// Makes one to three random changes: removes a character, cuts the text off, inserts
/// or writes over one of the splices, or repeats a part.
inline std::string mutant_of(std::string bytes, const std::vector<std::string>& splices,
                             std::mt19937& random) {
  const auto below = [&](std::size_t n) { return random() % n; };
  for (std::size_t change = 0; change <= below(3); ++change) {
    const std::size_t at = below(bytes.size() + 1);
    const std::string& splice = splices[below(splices.size())];
    switch (below(4)) {
    case 0:
      bytes.erase(at, 1);
      break;
    case 1:
      bytes.resize(at);
      break;
    case 2:
      bytes.replace(at, below(2) * splice.size(), splice);
      break;
    default:
      bytes.insert(at, bytes.substr(below(bytes.size() + 1), below(60)));
    }
  }
  return bytes;
}

}  // namespace blocks::testing
