#include "run/contact_room.hpp"

#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace blocks::run {

double likely_pairs(const Blocks& blocks, double margin) {
  const int count = blocks.size(), asked = std::min(count, 64);
  std::vector<Eigen::AlignedBox2d> boxes(static_cast<std::size_t>(count));
  for (int c = 0; c < blocks.corners(); ++c)
    boxes[static_cast<std::size_t>(blocks.corner_block[c])].extend(
        Vec2(blocks.corner.col(c)));
  double found = 0.0;
  for (int k = 0; k < asked; ++k) {
    const auto own = static_cast<std::size_t>(static_cast<long>(k) * count / asked);
    Eigen::AlignedBox2d wide = boxes[own];
    wide.min().array() -= margin, wide.max().array() += margin;
    found += static_cast<double>(
        std::count_if(boxes.begin(), boxes.end(),
                      [&](const auto& box) { return wide.intersects(box); }) -
        1);
  }
  return asked > 0 ? 0.5 * found * count / asked : 0.0;
}

double pairs_in_memory() {
  constexpr double bytes_of_pair = 2500.0;  // of two rectangles, measured
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGESIZE)) / bytes_of_pair;
}

}  // namespace blocks::run
