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
    longest = std::max(longest, 1.0001 * blocks.arm.col(c).norm());
  return longest;
}

}  // namespace

void MotionBounds::start(const Blocks& blocks, bool rigid_blocks) {
  rigid = rigid_blocks;
  longest.resize(static_cast<std::size_t>(blocks.size()));
  for (int b = 0; b < blocks.size(); ++b)
    longest[static_cast<std::size_t>(b)] = longest_arm(blocks, b);
  rounding = longest.empty()
                 ? 0.0
                 : 0x1p-50 * *std::max_element(longest.begin(), longest.end());
  begin_phase(blocks);
}

void MotionBounds::take_in(const Blocks& blocks, const std::vector<char>& changed) {
  const int n = blocks.size();
  longest.resize(static_cast<std::size_t>(n));
  centroid.conservativeResize(Eigen::NoChange, n);
  gradient.conservativeResize(Eigen::NoChange, n);
  for (int b = 0; b < n; ++b)
    if (changed[static_cast<std::size_t>(b)] != 0) {
      longest[static_cast<std::size_t>(b)] = longest_arm(blocks, b);
      centroid.col(b) = blocks.centroid.col(b);
      gradient.col(b) = blocks.gradient.col(b);
    }
}

void MotionBounds::begin_phase(const Blocks& blocks) {
  most = 0.0;
  centroid = blocks.centroid;
  gradient = blocks.gradient;
}

void MotionBounds::begin_phase(const std::vector<KeptPose>& start) {
  most = 0.0;
  centroid.resize(Eigen::NoChange, static_cast<Eigen::Index>(start.size()));
  gradient.resize(Eigen::NoChange, static_cast<Eigen::Index>(start.size()));
  for (const KeptPose& pose : start)
    centroid.col(pose.block) = pose.centroid, gradient.col(pose.block) = pose.gradient;
}

std::vector<KeptPose> MotionBounds::poses() const {
  std::vector<KeptPose> all;
  for (int b = 0; b < centroid.cols(); ++b)
    all.push_back({b, centroid.col(b), gradient.col(b)});
  return all;
}

}  // namespace blocks::dynamics
