#include "model/splitting.hpp"

#include <cstddef>
#include <utility>

#include "geometry/polygon.hpp"
#include "model/piece_map.hpp"

namespace blocks {
namespace {

/// Replaces the columns of the corners, in the order of the blocks.
void remake_corners(Blocks& blocks, const PieceMap& map) {
  Blocks made;
  made.arm.resize(2, map.corners());
  made.corner.resize(2, map.corners());
  made.joint.resize(static_cast<std::size_t>(map.corners()));
  for (int b = 0; b < map.blocks(); ++b) {
    const int first = map.first_corner(b), count = map.first_corner(b + 1) - first;
    for (int i = 0; i < count; ++i) {
      const int c = first + i;
      made.corner_block.push_back(b);
      made.next.push_back(i + 1 == count ? first : c + 1);
      made.previous.push_back(i == 0 ? first + count - 1 : c - 1);
    }
    made.first_corner.push_back(first + count);
    const Piece* const piece = map.piece(b);
    const int old =
        b < blocks.size() ? blocks.first_corner[b] : blocks.first_corner[map.parent(b)];
    for (int i = 0; i < count; ++i) {
      const auto c = static_cast<std::size_t>(first + i);
      if (piece == nullptr) {
        made.arm.col(first + i) = blocks.arm.col(old + i);
        made.corner.col(first + i) = blocks.corner.col(old + i);
        made.joint[c] = blocks.joint[static_cast<std::size_t>(old + i)];
        continue;
      }
      const auto k = static_cast<std::size_t>(i);
      made.corner.col(first + i) = piece->shape.outline[k];
      made.arm.col(first + i) = piece->shape.outline[k] - piece->centroid;
      const int side = piece->shape.side[k];
      made.joint[c] = side < 0 ? map.joint_of_chord(b)
                               : blocks.joint[static_cast<std::size_t>(old + side)];
    }
  }
  blocks.first_corner.swap(made.first_corner);
  blocks.corner_block.swap(made.corner_block);
  blocks.next.swap(made.next);
  blocks.previous.swap(made.previous);
  blocks.joint.swap(made.joint);
  blocks.arm.swap(made.arm);
  blocks.corner.swap(made.corner);
}

/// Gives block b the values of a piece. Its other columns are those of its parent.
void put_piece(Blocks& blocks, int b, const Piece& piece, double part_of_mass) {
  blocks.area[b] = piece.shape.area;
  blocks.mass[b] = piece.mass;
  blocks.inertia[b] = piece.inertia;
  blocks.second_moment.col(b) = piece.second_moment;
  blocks.centroid.col(b) = piece.centroid;
  blocks.velocity.col(b) = piece.velocity;
  blocks.spin[b] = piece.spin;
  blocks.stress.col(b) = piece.stress;
  blocks.gradient.col(b) = Eigen::Vector4d(1.0, 0.0, 0.0, 1.0);
  blocks.force.col(b) *= part_of_mass;
  blocks.moment[b] *= part_of_mass;
  const bool convex = geometry::check_outline(piece.shape.outline).convex;
  blocks.convex[static_cast<std::size_t>(b)] = convex ? 1 : 0;
  if (!convex)
    blocks.cut(b, piece.shape.outline);
}

void grow(Blocks& blocks, const std::vector<BlockSplit>& splits) {
  const int old = blocks.size(), now = old + static_cast<int>(splits.size());
  for (Eigen::VectorXd* column : {&blocks.area, &blocks.mass, &blocks.inertia,
                                  &blocks.angle, &blocks.spin, &blocks.moment})
    column->conservativeResize(now);
  for (Eigen::Matrix2Xd* column : {&blocks.centroid, &blocks.velocity, &blocks.force})
    column->conservativeResize(2, now);
  for (Eigen::Matrix4Xd* column :
       {&blocks.second_moment, &blocks.gradient, &blocks.applied, &blocks.stress,
        &blocks.strain_rate})
    column->conservativeResize(4, now);
  const bool scaled = blocks.has_scaled_masses();
  if (scaled)
    blocks.scale.conservativeResize(now);
  int b = old;
  for (const BlockSplit& split : splits) {
    if (scaled)
      blocks.scale[b] = blocks.scale[split.block];
    const auto parent = static_cast<std::size_t>(split.block);
    blocks.material.push_back(blocks.material[parent]);
    blocks.fixity.push_back(blocks.fixity[parent]);
    blocks.layer.push_back(blocks.layer[parent]);
    blocks.convex.push_back(1);
    blocks.angle[b] = blocks.angle[split.block];
    blocks.moment[b] = blocks.moment[split.block];
    blocks.force.col(b) = blocks.force.col(split.block);
    blocks.applied.col(b) = blocks.applied.col(split.block);
    blocks.strain_rate.col(b) = blocks.strain_rate.col(split.block);
    ++b;
  }
}

/// Deletes the convex parts of the blocks that split.
void delete_parts(Blocks& blocks, const PieceMap& map) {
  std::vector<int> kept;
  blocks.each_cut([&](int block, std::span<const int> corners) {
    if (map.piece(block) != nullptr)
      return;
    kept.push_back(block);
    kept.push_back(static_cast<int>(corners.size()));
    kept.insert(kept.end(), corners.begin(), corners.end());
  });
  blocks.cuts.swap(kept);
}

}  // namespace

void split_blocks(Model& model, const std::vector<BlockSplit>& splits) {
  Blocks& blocks = model.blocks;
  const PieceMap map(blocks, splits);
  move_contacts(model, map);
  move_loads(model.loads, blocks, map);
  delete_parts(blocks, map);
  remake_corners(blocks, map);
  grow(blocks, splits);
  int child = blocks.size() - static_cast<int>(splits.size());
  for (const BlockSplit& split : splits) {
    const auto& [stays, leaves] = split.pieces;
    const double whole = blocks.mass[split.block];
    put_piece(blocks, split.block, stays, stays.mass / whole);
    put_piece(blocks, child, leaves, leaves.mass / whole);
    ++child;
  }
  if (model.time_step.blocks > 0)
    model.time_step.blocks = blocks.size();
  model.search.invalidate();
}

}  // namespace blocks
