// Finds blocks, sides and corners by position, material or joint id. Removed blocks are
// never found. Indices count from 0. Independent of cards.
#pragma once

#include <vector>

#include "model/blocks.hpp"

namespace blocks {

/// A side or a corner of a block, both from 0.
struct BlockSide {
  int block = 0, side = 0;
  bool operator==(const BlockSide&) const = default;
};
struct BlockCorner {
  int block = -1, corner = -1;
  bool operator==(const BlockCorner&) const = default;
};

/// Returns the block that contains the point or has it on a side: the lowest of
/// several, -1 if there is none. The decision is exact for the present corners.
int block_at(const Blocks& blocks, const Vec2& point);

/// Returns the blocks whose centroid is in the box between two opposite corners, or on
/// its sides.
std::vector<int> blocks_in(const Blocks& blocks, const Vec2& corner,
                           const Vec2& opposite);

/// Returns the blocks of a material.
std::vector<int> blocks_of_material(const Blocks& blocks, int material);

/// Returns the sides with this joint id.
std::vector<BlockSide> sides_of_joint(const Blocks& blocks, int id);

/// Which sides count beside a line from a to b: all of them, or those of blocks on its
/// left or right.
enum class SidesOf { both, left, right };

/// Returns the sides that lie on the line from a to b, with both corners. Each corner
/// may be as far away as `tolerance` [L], but at least 1e-9 of the length, because
/// corners on slanted lines are rounded.
std::vector<BlockSide> sides_on(const Blocks& blocks, const Vec2& a, const Vec2& b,
                                SidesOf which, double tolerance = 0.0);

/// Returns the corner nearest to the point: of several, the one with the lowest block
/// and corner. Its block is -1 if there are no blocks.
BlockCorner nearest_corner(const Blocks& blocks, const Vec2& point);

}  // namespace blocks
