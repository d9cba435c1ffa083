#include "dynamics/decisions/motion_bounds.hpp"

#include <algorithm>
#include <cstddef>

namespace blocks::dynamics {

void MotionBounds::start(const Blocks& blocks, bool rigid_blocks) {
  rigid = rigid_blocks;
  longest.assign(static_cast<std::size_t>(blocks.size()), 0.0);
  // The factor covers the rounding of the norm and of the gradient.
  for (int c = 0; c < blocks.corners(); ++c) {
    double& arm = longest[blocks.corner_block[c]];
    arm = std::max(arm, 1.0001 * blocks.arm.col(c).norm());
  }
  rounding = longest.empty()
                 ? 0.0
                 : 0x1p-50 * *std::max_element(longest.begin(), longest.end());
  begin_phase(blocks);
}

void MotionBounds::begin_phase(const Blocks& blocks) {
  most = 0.0;
  centroid = blocks.centroid;
  gradient = blocks.gradient;
}

}  // namespace blocks::dynamics
