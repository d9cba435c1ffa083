// Which contacts may act, and how long: the decisions about pairs of blocks that a run
// keeps over several steps (docs/kept-decisions.md), as a checkpoint contains them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks {

/// Two blocks near each other, and how far they may move before they are decided again.
struct KeptPair {
  int low = 0, high = 0;  ///< blocks, low < high
  /// [L] limits of the motion of the two blocks, and of their neighbours as well. Not
  /// positive: the next step decides them.
  double limit = 0.0, limit_of_neighbours = 0.0;
  int contacts = 0;  ///< number of its entries in KeptDecisions::contacts
  int poses = 0;     ///< the same in KeptDecisions::poses
  int depths = 0;    ///< the same in KeptDecisions::depths
};

/// A contact that may act.
struct KeptContact {
  int corner = 0, edge = 0;
  bool tested = false;   ///< it acts if its corner is inside (19) and between the ends
  bool certain = false;  ///< it acts in any case
};

/// Where a block was when a decision was made.
struct KeptPose {
  int block = 0;
  geometry::Vec2 centroid = geometry::Vec2::Zero();    ///< [L]
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();  ///< deformation gradient
};

/// A depth on which a decision depends: that of the deepest corner of the part `other`
/// below a side of the part `own`. The decision holds while it is between two limits.
struct KeptDepth {
  int own_block = 0, own_part = 0;      ///< block, and number of the part in it
  int other_block = 0, other_part = 0;  ///< the same
  int side = 0;                         ///< number of the side in `own`
  double least = 0.0, most = 0.0;       ///< [L] limits
};

/// All decisions of a run. Blocks and corners have the numbers of the steps
/// (Model::order).
struct KeptDecisions {
  std::vector<KeptPair> pairs;  ///< near pairs of the last search, ascending
  std::vector<KeptContact> contacts;
  std::vector<KeptPose> poses;
  std::vector<KeptDepth> depths;
  std::vector<KeptPose> start;  ///< (blocks) at the beginning of the phase
  std::vector<int> pieces;  ///< blocks that have split since the last search, ascending
  long spoiled = 0;         ///< decisions of this phase that soon expire again

  bool empty() const { return start.empty(); }
};

}  // namespace blocks
