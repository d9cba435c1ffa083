#include "dynamics/decisions/motion_bounds.hpp"

#include <algorithm>
#include <cstddef>

namespace blocks::dynamics {
namespace {

/// Returns the longest arm of block b, rounded up, [L]. The factor covers the rounding
/// of the norm and of the gradient.
double longest_arm(const Blocks& blocks, int b) {
  double longest = 0.0;
  for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
    longest =
        std::max(longest, geometry::Certainty::arm_factor * blocks.arm.col(c).norm());
  return longest;
}

}  // namespace

void MotionBounds::start(const Blocks& blocks, bool rigid_blocks) {
  rigid = rigid_blocks;
  longest.resize(static_cast<std::size_t>(blocks.size()));
  for (int b = 0; b < blocks.size(); ++b)
    longest[static_cast<std::size_t>(b)] = longest_arm(blocks, b);
  path.assign(longest.size(), 0.0);
  longest_path = 0.0;
  find_rounding();
}

void MotionBounds::take_in(const Blocks& blocks, const std::vector<char>& changed) {
  longest.resize(static_cast<std::size_t>(blocks.size()));
  path.resize(longest.size(), 0.0);
  for (int b = 0; b < blocks.size(); ++b)
    if (changed[static_cast<std::size_t>(b)] != 0)
      longest[static_cast<std::size_t>(b)] = longest_arm(blocks, b);
  find_rounding();
}

void MotionBounds::find_rounding() {
  rounding = 0.0;
  for (const double arm : longest)
    rounding = std::max(rounding, geometry::Certainty::corner_rounding * arm);
}

}  // namespace blocks::dynamics
