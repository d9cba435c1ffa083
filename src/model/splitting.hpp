// Replaces blocks of a model by two pieces each (CRACK,
// docs/cracks.md#what-follows-a-piece). Independent of the rules that ask for it, and
// of the motion of the pieces.
#pragma once

#include <array>
#include <vector>

#include "geometry/split.hpp"
#include "model/model.hpp"

namespace blocks {

/// One of the two pieces of a block.
struct Piece {
  geometry::SplitPiece shape;
  double mass = 0.0;                             ///< [M]
  double inertia = 0.0;                          ///< [M L^2] about its centroid
  Eigen::Vector4d second_moment = {0, 0, 0, 0};  ///< [M L^2] about its centroid
  Vec2 centroid = {0, 0};                        ///< [L]
  Vec2 velocity = {0, 0};                        ///< [L/T]
  double spin = 0.0;                             ///< rad/T
  Eigen::Vector4d stress = {0, 0, 0, 0};  ///< [F/L^2] internal, rows 11, 12, 21, 22
};

/// A block and its two pieces.
struct BlockSplit {
  int block = 0;                ///< from 0
  std::array<Piece, 2> pieces;  ///< the first one keeps the number of the block
  std::array<geometry::ChordEnd, 2> ends;
  int joint = 0;  ///< joint id of the new faces
};

/// Replaces each block by its first piece and appends the second ones, in the order of
/// the list. Pieces are free, and their reference shape is the present one. Contacts
/// and loads follow the pieces; springs stay as they are. The time step and the order
/// of the steps are kept. The list of contacts must be up to date. splits: of different
/// free blocks.
void split_blocks(Model& model, const std::vector<BlockSplit>& splits);

}  // namespace blocks
