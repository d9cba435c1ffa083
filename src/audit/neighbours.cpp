#include "audit/neighbours.hpp"

#include <algorithm>
#include <numeric>

namespace blocks::audit {

std::vector<std::vector<int>> blocks_near_corners(const Blocks& blocks, double reach) {
  std::vector<int> by_x(blocks.corners());
  std::iota(by_x.begin(), by_x.end(), 0);
  const auto x = [&](int c) { return blocks.corner(0, c); };
  std::sort(by_x.begin(), by_x.end(), [&](int a, int b) { return x(a) < x(b); });

  std::vector<std::vector<int>> near(blocks.corners());
  for (int b = 0; b < blocks.size(); ++b) {
    const auto corners =
        blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
    Vec2 low = corners.rowwise().minCoeff(), high = corners.rowwise().maxCoeff();
    const double more = reach + 0.061 * (high - low).sum();
    // and all that lies straight below an edge, as deep as the block's deepest corner
    for (int e = blocks.first_corner[b]; e < blocks.first_corner[b + 1]; ++e) {
      const Vec2 p = blocks.corner.col(e), q = blocks.corner.col(blocks.next[e]);
      const Vec2 inwards = Vec2((q - p).y(), -(q - p).x()).normalized();
      const double deep = (inwards.transpose() * (corners.colwise() - p)).maxCoeff();
      for (const Vec2& end : {Vec2(p + deep * inwards), Vec2(q + deep * inwards)})
        low = low.cwiseMin(end), high = high.cwiseMax(end);
    }
    auto at = std::lower_bound(by_x.begin(), by_x.end(), low.x() - more,
                               [&](int c, double limit) { return x(c) < limit; });
    for (; at != by_x.end() && x(*at) <= high.x() + more; ++at) {
      const int other = blocks.corner_block[*at];
      const double y = blocks.corner(1, *at);
      if (y >= low.y() - more && y <= high.y() + more && other != b &&
          (blocks.is_free(b) || blocks.is_free(other)))
        near[*at].push_back(b);
    }
  }
  return near;
}

std::vector<std::vector<int>> blocks_near_blocks(const Blocks& blocks, double reach) {
  const int n = blocks.size();
  Eigen::Matrix2Xd low(2, n), high(2, n);
  for (int b = 0; b < n; ++b) {
    const auto corners =
        blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
    low.col(b) = corners.rowwise().minCoeff();
    high.col(b) = corners.rowwise().maxCoeff();
  }
  std::vector<int> by_x(n);
  std::iota(by_x.begin(), by_x.end(), 0);
  std::sort(by_x.begin(), by_x.end(),
            [&](int a, int b) { return low(0, a) < low(0, b); });
  std::vector<std::vector<int>> near(n);
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      const int a = by_x[i], b = by_x[j];
      if (low(0, b) > high(0, a) + reach)
        break;
      if (low(1, b) > high(1, a) + reach || low(1, a) > high(1, b) + reach ||
          (!blocks.is_free(a) && !blocks.is_free(b)))
        continue;
      near[a].push_back(b);
      near[b].push_back(a);
    }
  for (std::vector<int>& some : near)
    std::sort(some.begin(), some.end());
  return near;
}

}  // namespace blocks::audit
