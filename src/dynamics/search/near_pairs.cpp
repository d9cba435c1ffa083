#include "dynamics/search/near_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

constexpr double cells_per_block = 2.0;  ///< upper bound

/// A grid of square cells over all boxes. A cell is at least as large as a typical
/// block.
class Grid {
 public:
  Grid(const Blocks& blocks, const NearSearch& boxes) {
    if (blocks.size() == 0)
      return;
    lower_ = boxes.lower.front();
    Vec2 upper = boxes.upper.front();
    for (int b = 1; b < blocks.size(); ++b)
      lower_ = lower_.cwiseMin(boxes.lower[b]), upper = upper.cwiseMax(boxes.upper[b]);
    const Vec2 extent = upper - lower_;
    const double max = std::max(1.0, cells_per_block * blocks.size());
    const double side =
        std::max({1.5 * blocks.area.array().sqrt().mean(),
                  std::sqrt(extent.x() * extent.y() / max), extent.maxCoeff() / max});
    per_length_ = side > 0.0 ? 1.0 / side : 0.0;
    columns = index(extent.x(), 1 << 30) + 1;
    rows = index(extent.y(), 1 << 30) + 1;
  }
  int column(double x) const { return index(x - lower_.x(), columns); }
  int row(double y) const { return index(y - lower_.y(), rows); }
  /// Calls visit(cell) for each cell that a box touches.
  template <class Visit>
  void each(const Vec2& lower, const Vec2& upper, const Visit& visit) const {
    const int last = column(upper.x()), top = row(upper.y());
    for (int j = row(lower.y()); j <= top; ++j)
      for (int i = column(lower.x()); i <= last; ++i)
        visit(j * columns + i);
  }
  int columns = 1, rows = 1;

 private:
  int index(double distance, int count) const {
    const double at = distance * per_length_;
    return at > 0.0 ? static_cast<int>(std::min(at, count - 1.0)) : 0;  // 0 if NaN
  }
  Vec2 lower_ = Vec2::Zero();
  double per_length_ = 0.0;
};

void find_boxes(const Blocks& blocks, double reach, NearSearch& memory) {
  memory.lower.resize(static_cast<std::size_t>(blocks.size()));
  memory.upper.resize(static_cast<std::size_t>(blocks.size()));
  for (int b = 0; b < blocks.size(); ++b) {
    Vec2 lower = blocks.corner.col(blocks.first_corner[b]), upper = lower;
    for (int c = blocks.first_corner[b] + 1; c < blocks.first_corner[b + 1]; ++c) {
      const Vec2 corner = blocks.corner.col(c);
      lower = lower.cwiseMin(corner), upper = upper.cwiseMax(corner);
    }
    // Third parts are found at a distance, which depends on the present extents. Until
    // the next search, rotation makes their sum at most sqrt(2) times as large; the
    // rest of 1.5 is for strain. A corner that is outside an edge by less than the
    // slack still touches it.
    constexpr double part_of_extents =
        1.5 * geometry::third_reach + 2.0 * geometry::contact_slack;
    const double growth = reach + part_of_extents * (upper - lower).sum();
    memory.lower[b] = lower.array() - growth, memory.upper[b] = upper.array() + growth;
  }
}

}  // namespace

void find_near_pairs(const Blocks& blocks, double reach, NearSearch& memory,
                     std::vector<NearPair>& pairs) {
  find_boxes(blocks, reach, memory);
  const Grid grid(blocks, memory);
  memory.cells.sort(grid.columns * grid.rows, [&](const auto& add) {
    for (int b = 0; b < blocks.size(); ++b)
      if (!blocks.is_removed(b))
        grid.each(memory.lower[b], memory.upper[b], [&](int cell) { add(cell, b); });
  });
  pairs.clear();
  const auto meet = [&](int a, int b) {
    return ((memory.lower[a].x() <= memory.upper[b].x()) &
            (memory.lower[b].x() <= memory.upper[a].x()) &
            (memory.lower[a].y() <= memory.upper[b].y()) &
            (memory.lower[b].y() <= memory.upper[a].y())) != 0;
  };
  for (int a = 0; a < blocks.size(); ++a) {
    if (blocks.is_removed(a))
      continue;
    const std::size_t before = pairs.size();
    grid.each(memory.lower[a], memory.upper[a], [&](int cell) {
      memory.cells.each(cell, [&](int b) {
        if (b <= a || !meet(a, b) || !blocks.may_touch(a, b))
          return;
        // Two boxes may have several cells in common. Only the first of these adds the
        // pair.
        const Vec2 corner = memory.lower[a].cwiseMax(memory.lower[b]);
        if (grid.row(corner.y()) * grid.columns + grid.column(corner.x()) == cell)
          pairs.push_back({.low = a, .high = b});
      });
    });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(before), pairs.end());
  }
}

}  // namespace blocks::dynamics
