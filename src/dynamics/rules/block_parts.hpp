// The convex parts of all blocks, as corner numbers: the polygons that the contact rule
// decides about. A convex block is one part.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/covered_side.hpp"
#include "geometry/polygon.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// A side of a part, from corner `start` to corner `end`, clockwise. It is an edge of
/// its block, named by `start`, or an inner side between two parts of one block.
struct Side {
  int part = 0;
  int index = 0;  ///< of the side in its part, 0 ..
  int start = 0, end = 0;
  bool operator==(const Side&) const = default;
};

class BlockParts {
 public:
  /// Cuts every block that is not convex (geometry::convex_parts). Kept while the
  /// blocks keep their shapes.
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
  /// The side that ends where this one starts, and the one that starts where it ends.
  Side before(const Side& side) const {
    return this->side(side.part,
                      (side.index > 0 ? side.index : corners(side.part)) - 1);
  }
  Side after(const Side& side) const {
    return this->side(side.part,
                      side.index + 1 < corners(side.part) ? side.index + 1 : 0);
  }
  /// Between two parts of one block: covered by the part beside it, whatever happens.
  bool is_inner(const Blocks& blocks, const Side& side) const {
    return blocks.next[side.start] != side.end;
  }
  /// An edge with which no side of the part is in line, nor nearly so.
  bool is_plain(int part, int index) const {
    return is_plain_[first_corner_[part] + index];
  }
  /// The corners of a part: of a convex block as they stand in the memory, else in
  /// `copy`.
  geometry::Outline outline(const Blocks& blocks, int part,
                            geometry::Polygon& copy) const;
  /// The same inner side seen from the part beside it (geometry::convex_parts: every
  /// inner side has one).
  Side twin(const Side& inner) const;

 private:
  void find_plain_sides(const Blocks& blocks);
  /// With room for what strain may change.
  static bool may_be_in_line(const Blocks& blocks, const Side& first, const Side& next);

  std::vector<int> first_part_ = {0};    ///< (blocks + 1)
  std::vector<int> block_;               ///< (parts)
  std::vector<int> first_corner_ = {0};  ///< (parts + 1)
  std::vector<int> corner_;              ///< corner numbers of each part, clockwise
  std::vector<char> is_plain_;           ///< of the side that starts at each of them
};

}  // namespace blocks::dynamics
