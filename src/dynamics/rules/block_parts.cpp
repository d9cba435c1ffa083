#include "dynamics/rules/block_parts.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace blocks::dynamics {

void BlockParts::make(const Blocks& blocks) {
  first_part_.assign(1, 0);
  block_.clear();
  first_corner_.assign(1, 0);
  corner_.clear();
  const auto end_part = [&](int b) {
    block_.push_back(b);
    first_corner_.push_back(static_cast<int>(corner_.size()));
  };
  std::vector<std::pair<int, std::span<const int>>> cuts;
  blocks.each_cut([&](int b, auto corners) { cuts.emplace_back(b, corners); });
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const auto& l, const auto& r) { return l.first < r.first; });
  auto cut = cuts.begin();
  for (int b = 0; b < blocks.size(); ++b) {
    const int first = blocks.first_corner[b];
    if (blocks.convex[b]) {
      for (int c = first; c < blocks.first_corner[b + 1]; ++c)
        corner_.push_back(c);
      end_part(b);
    }
    for (; cut != cuts.end() && cut->first == b; ++cut) {
      for (const int c : cut->second)
        corner_.push_back(first + c);
      end_part(b);
    }
    first_part_.push_back(static_cast<int>(block_.size()));
  }
}

Side BlockParts::twin(const Side& inner) const {
  const int b = block_[inner.part];
  for (int part = first_part(b); part < end_part(b); ++part)
    for (int i = 0; part != inner.part && i < corners(part); ++i)
      if (const Side other = side(part, i);
          other.start == inner.end && other.end == inner.start)
        return other;
  return inner;
}

}  // namespace blocks::dynamics
