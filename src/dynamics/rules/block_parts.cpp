#include "dynamics/rules/block_parts.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

void BlockParts::make(const Blocks& blocks) {
  first_part_.assign(1, 0);
  block_.clear();
  first_corner_.assign(1, 0);
  corner_.clear();
  const auto end_part = [&](int b) {
    block_.push_back(b);
    first_corner_.push_back(static_cast<int>(corner_.size()));
  };
  std::vector<std::pair<int, std::span<const int>>> cuts;
  blocks.each_cut([&](int b, auto corners) { cuts.emplace_back(b, corners); });
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const auto& l, const auto& r) { return l.first < r.first; });
  auto cut = cuts.begin();
  for (int b = 0; b < blocks.size(); ++b) {
    const int first = blocks.first_corner[b];
    if (blocks.convex[b]) {
      for (int c = first; c < blocks.first_corner[b + 1]; ++c)
        corner_.push_back(c);
      end_part(b);
    }
    for (; cut != cuts.end() && cut->first == b; ++cut) {
      for (const int c : cut->second)
        corner_.push_back(first + c);
      end_part(b);
    }
    first_part_.push_back(static_cast<int>(block_.size()));
  }
  find_isolated_sides(blocks);
}

void BlockParts::find_isolated_sides(const Blocks& blocks) {
  is_isolated_.resize(corner_.size());
  for (int part = 0; part < static_cast<int>(block_.size()); ++part)
    for (int i = 0; i < corners(part); ++i) {
      const int n = corners(part);
      const Side own = side(part, i), before = side(part, (i + n - 1) % n),
                 after = side(part, (i + 1) % n);
      is_isolated_[first_corner_[part] + i] = !is_inner(blocks, own) &&
                                              !may_be_in_line(blocks, before, own) &&
                                              !may_be_in_line(blocks, own, after);
    }
}

namespace {

/// Returns the vector along a side as the block was made: the present one would make
/// the answer depend on the step in which the parts were made.
Vec2 along(const Blocks& blocks, const Side& side) {
  return blocks.arm.col(side.end) - blocks.arm.col(side.start);
}

}  // namespace

bool BlockParts::may_be_in_line(const Blocks& blocks, const Side& first,
                                const Side& next) {
  constexpr double slack =
      geometry::Certainty::in_line_slacks * geometry::contact_slack;
  const Vec2 e = along(blocks, first), g = along(blocks, next);
  return e.dot(g) > 0.0 && std::abs(geometry::cross(e, g)) <=
                               slack * std::min(e.squaredNorm(), g.squaredNorm());
}

}  // namespace blocks::dynamics
