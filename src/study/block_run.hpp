// A run of one block on a domain, for the comparison of two such runs.
#pragma once

#include <memory>

#include "dynamics/workspace.hpp"
#include "study/variants.hpp"

namespace blocks::study {

/// Where the block is.
struct BlockPlace {
  Vec2 centroid = {0, 0};  ///< [L]
  double angle = 0.0;      ///< rad
};

/// Returns an upper bound of the distance between the same point of a block in two
/// places, [L]. arm: the longest distance of a point of the block from its centroid.
double distance_apart(const BlockPlace& a, const BlockPlace& b, double arm);

/// A model in motion. Its last block is the one that moves. The others are fixed, or
/// pieces of a domain that are bonded to each other.
class BlockRun {
 public:
  BlockRun(const Model& start, const Variant& variant);

  /// Makes one step. Returns whether all numbers are finite.
  bool step();
  geometry::Polygon outline() const { return model.blocks.outline(moving_); }
  BlockPlace place() const;
  double arm() const { return arm_of(moving_); }
  /// Returns the depth of the deepest contact of the block that acted in the last step,
  /// [L].
  double deepest_contact() const;
  /// Returns 2 sqrt(E / K), [L]: an overlap that the energy E of the block explains,
  /// which includes the work of gravity in its deepest fall so far.
  double energy_overlap() const;
  /// Returns 2 F / K, [L]: an overlap that the load F of the block explains.
  double load_overlap() const;

  /// Returns how far any point of another block has moved at most, [L].
  double yielding() const;

  Model model;

 private:
  double arm_of(int block) const;

  dynamics::Workspace work_;
  std::unique_ptr<VariantRun> rules_;
  int moving_ = 0;
  double kinetic_ = 0.0;    ///< energy at the start
  double fallen_ = 0.0;     ///< the largest work of gravity so far, per mass
  Eigen::Matrix2Xd start_;  ///< centroids
};

/// Turns the last block about its centroid by `turn` (rad, anticlockwise) and shifts
/// it.
void disturb_last_block(Blocks& blocks, const Vec2& shift, double turn);

}  // namespace blocks::study
