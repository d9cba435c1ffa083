#include "geometry/merge.hpp"

#include <cstddef>

#include "geometry/exact/merge.hpp"

namespace blocks::geometry::exact {

std::vector<std::size_t> merge_slender(const std::vector<Rational>& sides,
                                       const Rational& length_to_height,
                                       const Rational& smallest,
                                       std::vector<Absorption>& record) {
  const std::size_t last = sides.size() - 1;
  std::vector<std::size_t> kept = {0};
  const auto absorb = [&](std::size_t block, std::size_t into, const Rational& ratio) {
    record.push_back({static_cast<int>(block), static_cast<int>(into), nearest(ratio)});
  };
  // Block i lies between sides i - 1 and i. With the blocks that it has absorbed, it
  // begins at the last side kept. So one pass leaves no slender block except, perhaps,
  // the last.
  for (std::size_t i = 1; i <= last; ++i) {
    const Rational ratio = (sides[i] - sides[kept.back()]) * length_to_height;
    if (ratio >= smallest) {
      kept.push_back(i);
    } else if (i < last) {
      absorb(i, i + 1, ratio);
    } else {
      if (kept.size() > 1) {
        absorb(last, kept.back(), ratio);
        kept.pop_back();
      }
      kept.push_back(last);
    }
  }
  return kept;
}

}  // namespace blocks::geometry::exact
