// Where the corners, sides, contacts and loads of blocks are after the blocks have
// split. Part of splitting.cpp.
#pragma once

#include <vector>

#include "model/splitting.hpp"

namespace blocks {

/// Maps the corners and sides of a model to those of its pieces. Blocks and corners are
/// numbered from 0; new blocks have the numbers after the old ones. Refers to its
/// arguments, and needs the corners of the blocks before they are replaced.
class PieceMap {
 public:
  PieceMap(const Blocks& blocks, const std::vector<BlockSplit>& splits);

  /// The number of blocks and of corners after the splits.
  int blocks() const { return static_cast<int>(first_corner_.size()) - 1; }
  int corners() const { return first_corner_.back(); }
  int first_corner(int block) const {
    return first_corner_[static_cast<std::size_t>(block)];
  }
  /// Returns the split of an old block; null if it does not split.
  const BlockSplit* split(int block) const;
  /// Returns the piece that a block is; null if it has not split.
  const Piece* piece(int block) const;
  /// Returns the block from which a new block split off.
  int parent(int block) const;
  int joint_of_chord(int block) const;
  /// Returns the number of piece 0 or 1 of an old block that splits.
  int number(int block, int piece) const;

  /// Returns the new number of a corner. A corner at an end of the chord is one of both
  /// pieces; the result is that of the piece that keeps the number.
  int corner(int old) const;
  /// Returns the new number of the edge that begins at an old corner. If the edge was
  /// cut, the result is the part that holds the foot of `point`.
  int edge(int old, const Vec2& point) const;

  /// A part of an old side: of block `block`, side `side`, from the share `begin` of
  /// the old side to the share `end`.
  struct SidePart {
    int block = 0, side = 0;
    double begin = 0.0, end = 1.0;
  };
  /// Returns the parts of a side of an old block, one or two, in the direction of the
  /// side.
  std::vector<SidePart> parts_of_side(int block, int side) const;

 private:
  const Blocks& old_;
  const std::vector<BlockSplit>& splits_;
  std::vector<int> split_of_;  ///< (old blocks) index in splits_; -1: does not split
  std::vector<int> first_corner_;  ///< (blocks + 1)
};

/// Moves the contacts between blocks and with planes to the pieces, and sorts them.
void move_contacts(Model& model, const PieceMap& map);

/// Moves the loads to the pieces: pressures and quiet sides are divided where their
/// side was cut, and forces by mass.
void move_loads(Loads& loads, const Blocks& blocks, const PieceMap& map);

}  // namespace blocks
