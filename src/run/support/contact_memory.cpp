#include "run/support/contact_memory.hpp"

#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace blocks::run {
namespace {

/// Measured bytes per pair of rectangles. For touching bricks, only nearby corners and
/// edges are listed. With a wide margin, every corner is listed with every edge.
constexpr double bytes_of_touching = 800.0, bytes_of_all = 5000.0;

}  // namespace

LikelyList likely_list(const Blocks& blocks, double margin) {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b))
      continue;
    Eigen::AlignedBox2d& box = boxes.emplace_back();
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
      box.extend(Vec2(blocks.corner.col(c)));
  }
  const int count = static_cast<int>(boxes.size()), sample_size = std::min(count, 64);
  LikelyList list;
  for (int k = 0; k < sample_size; ++k) {
    const auto own =
        static_cast<std::size_t>(static_cast<long>(k) * count / sample_size);
    Eigen::AlignedBox2d wide = boxes[own];
    const bool all = margin > 0.5 * wide.sizes().minCoeff();
    const double size = wide.volume();
    wide.min().array() -= margin, wide.max().array() += margin;
    // A pair is counted for its smaller block, because one large floor below all bricks
    // is not a representative sample.
    double near = -0.5;  // excludes the block itself
    for (const Eigen::AlignedBox2d& box : boxes)
      if (box.volume() >= size && wide.intersects(box))
        near += box.volume() > size ? 1.0 : 0.5;
    const double pairs = near * count / sample_size;
    list.pairs += pairs;
    list.bytes += pairs * (all ? bytes_of_all : bytes_of_touching);
  }
  return list;
}

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace blocks::run
