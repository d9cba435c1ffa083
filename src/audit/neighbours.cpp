#include "audit/neighbours.hpp"

#include <algorithm>

#include "geometry/contact_constants.hpp"

namespace blocks::audit {

std::vector<std::vector<int>> blocks_near_blocks(const Blocks& blocks, double reach) {
  const int n = blocks.size();
  Eigen::Matrix2Xd low(2, n), high(2, n);
  for (int b = 0; b < n; ++b) {
    const auto corners =
        blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
    low.col(b) = corners.rowwise().minCoeff();
    high.col(b) = corners.rowwise().maxCoeff();
    const double growth = geometry::third_reach * (high.col(b) - low.col(b)).sum();
    low.col(b).array() -= growth, high.col(b).array() += growth;
  }
  std::vector<int> by_x;
  for (int b = 0; b < n; ++b)
    if (!blocks.is_removed(b))
      by_x.push_back(b);
  std::sort(by_x.begin(), by_x.end(),
            [&](int a, int b) { return low(0, a) < low(0, b); });
  std::vector<std::vector<int>> near(n);
  for (std::size_t i = 0; i < by_x.size(); ++i)
    for (std::size_t j = i + 1; j < by_x.size(); ++j) {
      const int a = by_x[i], b = by_x[j];
      if (low(0, b) > high(0, a) + reach)
        break;
      if (low(1, b) > high(1, a) + reach || low(1, a) > high(1, b) + reach ||
          !blocks.may_touch(a, b))
        continue;
      near[a].push_back(b);
      near[b].push_back(a);
    }
  for (std::vector<int>& some : near)
    std::sort(some.begin(), some.end());
  return near;
}

}  // namespace blocks::audit
