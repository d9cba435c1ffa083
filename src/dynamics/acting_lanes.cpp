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
  travel = 0.0;
  // no chord is longer than its arc; a little more for the roots
  for (int c = 0; c < blocks.corners(); ++c) {
    double& most = longest[blocks.corner_block[c]];
    most = std::max(most, 1.0001 * blocks.arm.col(c).norm());
  }
  // The same whenever groups are made, so that a run and its restart count the same
  // travel, though arms that turn change by round-off.
  std::transform(longest.begin(), longest.end(), longest.begin(), rounded_up);
}

}  // namespace blocks::dynamics
