// The parts that may continue one of the two parts of a pair
// (docs/contact-rule.md#third-parts).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/part_box.hpp"
#include "dynamics/support/groups.hpp"
#include "geometry/contact_constants.hpp"
#include "geometry/polygon.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Calls visit(part) for the other parts of the block of `own` and for the parts of all
/// blocks that may lie near both blocks and may touch that of `other`. neighbours: the
/// blocks that each block is paired with.
///
/// The list of either block has all blocks that are near both, so the shorter one is
/// used: a long floor costs its bricks no more than a short one. But the list of a
/// block that stays where it is lacks other such blocks, so that of `own` must move.
template <class Visit>
void each_third_part(const Blocks& blocks, const BlockParts& parts,
                     const Groups& neighbours, int own, int other, const Visit& visit) {
  const int own_block = parts.block(own), other_block = parts.block(other);
  const bool own_moves = blocks.is_free(own_block) || blocks.is_driven(own_block);
  const bool by_own =
      own_moves && neighbours.count(own_block) < neighbours.count(other_block);
  neighbours.each(by_own ? own_block : other_block, [&](int block) {
    if (block != own_block && block != other_block &&
        blocks.may_touch(block, other_block))
      for (int part = parts.first_part(block); part < parts.end_part(block); ++part)
        visit(part);
  });
  for (int part = parts.first_part(own_block); part < parts.end_part(own_block); ++part)
    if (part != own)
      visit(part);
}

/// The third parts of one part of a pair. The memory is reused.
class ThirdParts {
 public:
  /// Collects the third parts of `own` whose boxes meet the grown ones of both, so the
  /// result does not depend on how far the list of pairs reaches.
  void collect(const Blocks& blocks, const BlockParts& parts, const Groups& neighbours,
               int own, int other) {
    count_ = 0;
    const PartBox of_own = PartBox(blocks, parts, own).grown(geometry::third_reach),
                  of_other = PartBox(blocks, parts, other).grown(geometry::third_reach);
    each_third_part(blocks, parts, neighbours, own, other, [&](int part) {
      const PartBox box(blocks, parts, part);
      if (!box.meets(of_own) || !box.meets(of_other))
        return;
      if (outlines_.size() == count_)
        outlines_.emplace_back(), part_.emplace_back();
      part_[count_] = part;
      geometry::Polygon& outline = outlines_[count_++];
      outline.clear();
      for (int i = 0; i < parts.corners(part); ++i)
        outline.push_back(blocks.corner.col(parts.corner(part, i)));
    });
  }
  /// Calls visit(part, outline) for each of them.
  template <class Visit> void each(const Visit& visit) const {
    for (std::size_t i = 0; i < count_; ++i)
      visit(part_[i], outlines_[i]);
  }
  /// Returns whether condition(outline) is true for one of the parts.
  template <class Condition> bool any(const Condition& condition) const {
    return std::any_of(outlines_.begin(),
                       outlines_.begin() + static_cast<std::ptrdiff_t>(count_),
                       condition);
  }

 private:
  std::vector<int> part_;
  std::vector<geometry::Polygon> outlines_;
  std::size_t count_ = 0;
};

}  // namespace blocks::dynamics
