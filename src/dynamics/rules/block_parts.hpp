// The convex parts of all blocks, as corner numbers. The contact rule is applied to
// pairs of these polygons. A convex block is one part.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/outline.hpp"
#include "geometry/polygon.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// A side of a part, from corner `start` to corner `end`, clockwise. It is an edge of
/// its block, named by `start`, or an inner side between two parts of one block.
struct Side {
  int part = 0;
  int index = 0;  ///< index of the side in its part, from 0
  int start = 0, end = 0;
  bool operator==(const Side&) const = default;
};

class BlockParts {
 public:
  /// Collects the parts of all blocks. The parts of a block that is not convex are
  /// those of Blocks::cuts. The parts stay valid as long as no block is added or
  /// changes its number of corners.
  void make(const Blocks& blocks);

  int first_part(int block) const { return first_part_[block]; }
  int end_part(int block) const { return first_part_[block + 1]; }
  int block(int part) const { return block_[part]; }
  int corners(int part) const { return first_corner_[part + 1] - first_corner_[part]; }
  int corner(int part, int index) const { return corner_[first_corner_[part] + index]; }

  Side side(int part, int index) const {
    const int next = index + 1 < corners(part) ? index + 1 : 0;
    return {part, index, corner(part, index), corner(part, next)};
  }
  /// Returns whether the side is between two parts of one block.
  bool is_inner(const Blocks& blocks, const Side& side) const {
    return blocks.next[side.start] != side.end;
  }
  /// Returns whether the side is an edge of the block and no other side of the part is
  /// in line with it, or nearly so.
  bool is_isolated(int part, int index) const {
    return is_isolated_[first_corner_[part] + index];
  }

 private:
  void find_isolated_sides(const Blocks& blocks);
  /// Returns whether two successive sides are in line, or may become so by strain.
  static bool may_be_in_line(const Blocks& blocks, const Side& first, const Side& next);

  std::vector<int> first_part_ = {0};    ///< (blocks + 1)
  std::vector<int> block_;               ///< (parts)
  std::vector<int> first_corner_ = {0};  ///< (parts + 1)
  std::vector<int> corner_;              ///< corner numbers of each part, clockwise
  std::vector<char>
      is_isolated_;  ///< (corner_) of the side that starts at each of them
};

}  // namespace blocks::dynamics
