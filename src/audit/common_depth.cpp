#include "audit/common_depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::audit {

CommonDepth::CommonDepth(const Blocks& blocks) : blocks_(blocks) {
  for (const double x : blocks.corner.reshaped())
    lattice_.include(x);
  for (int c = 0; c < blocks.corners(); ++c)
    corner_.push_back(lattice_(Vec2(blocks.corner.col(c))));
}

/// Returns whether a point is on the border of a block or inside. If it is inside, a
/// vertical ray from it upwards leaves the block once more than it enters.
bool CommonDepth::holds(int block, const Point& point) const {
  int crossings = 0;
  for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e) {
    const Point &p = corner_[e], &q = corner_[blocks_.next[e]];
    const int side = sign(cross(q - p, point - p));
    if (side == 0 && sign(dot(p - point, q - point)) <= 0)
      return true;
    if ((p.x > point.x) != (q.x > point.x))
      crossings += q.x > p.x ? side < 0 : -(side > 0);
  }
  return crossings != 0;
}

// The extreme points of the intersection are corners of one block that lie in the
// other, or crossings of two edges.
double CommonDepth::along_normal(int edge, int other) const {
  const int own = blocks_.corner_block[edge];
  const Point along = corner_[blocks_.next[edge]] - corner_[edge];
  const auto depth = [&](const Point& p) { return cross(p - corner_[edge], along); };
  double min = std::numeric_limits<double>::infinity(), max = -min;
  const auto reaches = [&](double at) {
    min = std::min(min, at), max = std::max(max, at);
  };
  for (const auto& [of, in] : {std::pair(own, other), std::pair(other, own)})
    for (int c = blocks_.first_corner[of]; c < blocks_.first_corner[of + 1]; ++c)
      if (holds(in, corner_[c]))
        reaches(lattice_.rounded(depth(corner_[c]), 2));
  for (int e = blocks_.first_corner[own]; e < blocks_.first_corner[own + 1]; ++e) {
    const Point &p = corner_[e], &q = corner_[blocks_.next[e]];
    for (int f = blocks_.first_corner[other]; f < blocks_.first_corner[other + 1];
         ++f) {
      const Point &r = corner_[f], &s = corner_[blocks_.next[f]];
      const Whole from = cross(q - p, r - p), to = cross(q - p, s - p);
      if (sign(from) * sign(to) >= 0 ||
          sign(cross(s - r, p - r)) * sign(cross(s - r, q - r)) >= 0)
        continue;
      const Whole weighted = depth(s) * from - depth(r) * to;
      reaches(lattice_.rounded(weighted, 4) / lattice_.rounded(from - to, 2));
    }
  }
  return max > min ? (max - min) / std::sqrt(lattice_.rounded(dot(along, along), 2))
                   : 0.0;
}

}  // namespace blocks::audit
