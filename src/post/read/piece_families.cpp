#include "post/read/piece_families.hpp"

namespace blocks::post {

std::vector<int> families_of(const Frame& frame) {
  const auto n = static_cast<std::size_t>(frame.size());
  std::vector<int> families(n, 0);
  if (frame.parent.size() < n)
    return families;
  // A parent has a lower number than its pieces.
  for (std::size_t b = 0; b < n; ++b) {
    if (frame.parent[b] < 1 || frame.parent[b] > static_cast<int>(b))
      continue;
    const auto parent = static_cast<std::size_t>(frame.parent[b]) - 1;
    if (families[parent] == 0)
      families[parent] = frame.parent[b];
    families[b] = families[parent];
  }
  return families;
}

}  // namespace blocks::post
