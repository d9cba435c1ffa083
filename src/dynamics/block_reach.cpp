#include "dynamics/block_reach.hpp"

#include "dynamics/closed_joint.hpp"

namespace blocks::dynamics {

void BlockReach::set(const Blocks& blocks, int b, double tolerance) {
  first = blocks.first_corner[b];
  convex = blocks.convex[b];
  const double travel = 2.0 * tolerance + shield_reach(blocks, b);
  const int count = blocks.corners_of(b);
  edges.clear();
  for (int e = first; e < first + count; ++e)
    edges.emplace_back(blocks, b, e, travel);
  const auto corners = blocks.corner.middleCols(first, count);
  lower = corners.rowwise().minCoeff(), upper = corners.rowwise().maxCoeff();
  // no edge is longer than the two extents together
  const double near = travel + geometry::contact_slack * (upper - lower).sum();
  for (const Reach& reach : edges)
    reach.extend(lower, upper);
  lower.array() -= near, upper.array() += near;
}

}  // namespace blocks::dynamics
