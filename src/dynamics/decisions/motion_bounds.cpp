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
  // The harmonic mean: that of many small blocks and a large one is small.
  constexpr double part_of_arm = 1.0 / 128.0;
  double sum = 0.0;
  rounding = 0.0;
  for (const double arm : longest) {
    sum += 1.0 / arm;
    rounding = std::max(rounding, 0x1p-50 * arm);
  }
  phase_length = part_of_arm * static_cast<double>(longest.size()) / sum;
  begin_phase(blocks);
}

void MotionBounds::begin_phase(const Blocks& blocks) {
  most = 0.0;
  centroid = blocks.centroid;
  gradient = blocks.gradient;
}

}  // namespace blocks::dynamics
