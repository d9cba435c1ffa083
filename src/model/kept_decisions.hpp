// Which contacts may act, and how long: the decisions about pairs of blocks that a run
// keeps over several steps (docs/kept-decisions.md), as a checkpoint contains them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks {

/// Where two blocks were, one against the other.
struct PairPose {
  geometry::Vec2 apart =
      geometry::Vec2::Zero();  ///< [L] from one centroid to the other
  Eigen::Vector4d low = Eigen::Vector4d::Zero();  ///< deformation gradient of the first
  Eigen::Vector4d high = Eigen::Vector4d::Zero();  ///< the same of the second
};

/// How long a decision certainly holds. The default has ended already.
struct Validity {
  /// [L] The validity distance: the motion of the two blocks since `pose` has to be
  /// less. 0 for decisions of the exact rule.
  double distance = 0.0;
  /// [L] The largest path of any block (KeptDecisions::longest_path) has to be less: a
  /// neighbour may matter then. Infinite if no neighbour, not even a new one, can
  /// matter.
  double until = 0.0;
  PairPose pose;
};

/// Two blocks near each other, and how long their decision holds.
struct KeptPair {
  int low = 0, high = 0;  ///< blocks, low < high
  Validity validity;
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

  /// Returns the corner at the end of an arm, with the bits of a step, [L].
  geometry::Vec2 corner(const geometry::Vec2& arm) const {
    return centroid + geometry::Vec2(gradient[0] * arm.x() + gradient[1] * arm.y(),
                                     gradient[3] * arm.y() + gradient[2] * arm.x());
  }
};

/// A depth on which a decision depends: that of the deepest corner of the part `other`
/// below a side of the part `own`. The decision holds while it is between two limits.
struct KeptDepth {
  int own_block = 0, own_part = 0;      ///< block, and number of the part in it
  int other_block = 0, other_part = 0;  ///< the same
  int side = 0;                         ///< number of the side in `own`
  double min = 0.0, max = 0.0;          ///< [L] limits
};

/// All decisions of a run. Blocks and corners have the numbers of the steps
/// (Model::order).
struct KeptDecisions {
  std::vector<KeptPair> pairs;  ///< near pairs of the last search, ascending
  std::vector<KeptContact> contacts;
  std::vector<KeptPose> poses;
  std::vector<KeptDepth> depths;
  std::vector<int> pieces;  ///< blocks that have split since the last search, ascending
  /// [L] bound of the path of every block since the decisions began
  double longest_path = 0.0;
  int blocks = 0;  ///< number of blocks at the last search; 0: no decisions

  bool empty() const { return blocks == 0; }
};

}  // namespace blocks
