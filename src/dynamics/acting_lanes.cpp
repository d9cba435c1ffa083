#include "dynamics/acting_lanes.hpp"

#include <cmath>

namespace blocks::dynamics {
namespace {

/// To 7 bits.
double rounded_up(double length) {
  int exponent = 0;
  const double mantissa = std::frexp(length, &exponent);
  return std::ldexp(std::ceil(std::ldexp(mantissa, 7)), exponent - 7);
}

}  // namespace

void Swing::start(const Blocks& blocks, bool rigid_blocks) {
  rigid = rigid_blocks;
  for (std::vector<double>* column : {&longest, &sum, &way})
    column->assign(blocks.size(), 0.0);
  shape.resize(4, rigid ? 0 : blocks.size());
  shape.colwise() = Eigen::Vector4d(1.0, 0.0, 0.0, 1.0);
  reach.setZero(2, shape.cols());
  travel = 0.0;
  // no chord is longer than its arc; a little more for the roots
  for (int c = 0; c < blocks.corners(); ++c) {
    double& most = longest[blocks.corner_block[c]];
    most = std::max(most, 1.0001 * blocks.arm.col(c).norm());
    if (!rigid) {
      auto most_of_each = reach.col(blocks.corner_block[c]);
      most_of_each = most_of_each.cwiseMax(1.0001 * blocks.arm.col(c).cwiseAbs());
    }
  }
  // The same whenever groups are made, so that a run and its restart count the same
  // travel, though arms that turn change by round-off.
  std::transform(longest.begin(), longest.end(), longest.begin(), rounded_up);
}

double Swing::reshaped(int b, const Eigen::Vector4d& since) const {
  const Eigen::Array4d change = (shape.col(b) - since).cwiseAbs();
  const double along_x = change[0] * reach(0, b) + change[2] * reach(1, b);
  const double along_y = change[1] * reach(0, b) + change[3] * reach(1, b);
  return std::sqrt(along_x * along_x + along_y * along_y);
}

}  // namespace blocks::dynamics
