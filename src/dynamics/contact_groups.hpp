// Records of one corner against the edges of one block, which are decided together
// (rule 12), the pairs of blocks they belong to, and for how long decisions stand.
#pragma once

#include <cmath>
#include <vector>

#include "dynamics/contact_lanes.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// How far the arms of each block may have turned and strained, beside what its angle
/// tells: no arm has changed by more than `sum` and `per_radian` times the change of
/// the angle.
struct Swing {
  std::vector<double> sum;         ///< (n) [L] grows with every step
  std::vector<double> per_radian;  ///< (n) [L] 0: all is in the sum (deformable blocks)
  /// (n) [L] Way of the centroid and twice that of the arms, rounded up: the ways of
  /// two blocks together grow by no less than relative_motion.
  std::vector<double> way;

  /// For these blocks as they stand.
  void start(const Blocks& blocks, bool rigid);
};

/// How two blocks stood to each other.
struct RelativePose {
  double x = 0.0, y = 0.0;              ///< [L] between the centroids
  double angle_a = 0.0, angle_b = 0.0;  ///< rad
  double swing_a = 0.0, swing_b = 0.0;  ///< [L]
};

inline RelativePose relative_pose(const Blocks& blocks, const Swing& swing, int a,
                                  int b) {
  return {blocks.centroid(0, a) - blocks.centroid(0, b),
          blocks.centroid(1, a) - blocks.centroid(1, b),
          blocks.angle[a],
          blocks.angle[b],
          swing.sum[a],
          swing.sum[b]};
}

/// Bound on how far the two blocks have moved against each other since then: no
/// difference of two of their corners, or of a corner and a centroid, has changed by
/// more, [L]: two of one block by its arms alone. A distance: from one pose to a third
/// never farther than by way of a second.
inline double relative_motion(const Blocks& blocks, const Swing& swing, int a, int b,
                              const RelativePose& since) {
  const RelativePose now = relative_pose(blocks, swing, a, b);
  const double x = now.x - since.x, y = now.y - since.y;
  const double arm_a = (now.swing_a - since.swing_a) +
                       swing.per_radian[a] * std::abs(now.angle_a - since.angle_a);
  const double arm_b = (now.swing_b - since.swing_b) +
                       swing.per_radian[b] * std::abs(now.angle_b - since.angle_b);
  return std::sqrt(x * x + y * y) + 2.0 * (arm_a > arm_b ? arm_a : arm_b);
}

/// What is known of a group without deciding it again. `travel` [L]: while the two
/// blocks have moved against each other by less (relative_motion), the record
/// `candidate` acts if its corner is inside its edge (19), and no other one; -1: none
/// acts. 0: nothing is known.
struct Certainty {
  int candidate = -1;
  double travel = 0.0;
};

/// Records first .. last - 1 of the contact list.
struct ContactGroup {
  int first = 0, last = 0;
  int corner_block = 0, edge_block = 0;
  /// The edges' block is not convex: the group after this one holds the same records,
  /// for the second edge of a notch.
  bool reentrant = false, of_notch = false;
  int hopeless = 0;  ///< decisions left for which certainty is not even tried
  int acting = -1;   ///< the record that acts, -1: none, as last decided
  Certainty certain;
  RelativePose pose;  ///< when decided
};

/// The groups of two blocks, which stand side by side.
struct ContactPair {
  int low = 0, high = 0;    ///< the two blocks
  int first = 0, last = 0;  ///< groups
  double certain = 0.0;     ///< [L] until the first of its groups has to be decided
  RelativePose pose;
};

/// No decision of a pair has to be renewed while the ways of its two blocks (Swing)
/// add up to less than `limit`: a quick look before relative_motion.
struct PairWatch {
  double limit = 0.0;  ///< [L]
  int low = 0, high = 0;
};

/// Elastic force that a record held when it ceased to act.
struct LostForce {
  int group, record;
  double normal, shear;  ///< [F] FN > 0, FS
};

/// The extremes over the contacts that act in a step.
struct Extremes {
  double overlap = 0.0;  ///< [L] deepest
  double spring = 0.0;   ///< [F] largest elastic normal force
  void include(double depth, double force) {
    overlap = depth > overlap ? depth : overlap;
    spring = force > spring ? force : spring;
  }
};

/// The groups of a list, and what passes between them. Working state between searches:
/// not part of the model, and without influence on results.
struct ContactGroups {
  std::vector<ContactGroup> all;  ///< in the order of the list
  std::vector<ContactPair> pairs;
  std::vector<PairWatch> watch;  ///< (pairs)
  std::vector<int> by_corner;    ///< indices into `all`, corner after corner
  std::vector<int>
      first_of_corner;  ///< (corners + 1) where a corner's begin in by_corner

  // What acts, or is a candidate to, one to a lane, in the order of the groups. Between
  // load() and store() the springs are here and not in the list.
  ContactLanes lanes;
  std::vector<int> record;     ///< (lanes) -1: none any more
  std::vector<int> group;      ///< (lanes) index into `all`
  std::vector<int> lane_of;    ///< (groups) -1: none
  std::vector<int> low_lanes;  ///< (blocks + 1) where those of which a block is the
                               ///< lower one begin; they stand side by side
  std::vector<int>
      high_lane;  ///< lanes of which it is the higher one, block after block
  std::vector<int> high_lanes;  ///< (blocks + 1) where a block's begin in high_lane
  bool lanes_complete = false;  ///< no group lacks a lane
  bool loaded = false;          ///< the lanes hold what the list does not know yet

  std::vector<LostForce> lost;  ///< in this step
  Swing swing;                  ///< of the blocks since the groups were made
  /// What one thread finds.
  struct Share {
    std::vector<LostForce> lost;
    bool lanes_complete = true;
    Extremes extremes;
    unsigned long long exact_calls = 0;
  };
  std::vector<Share> shares;  ///< (threads)

  /// All decisions have to be renewed.
  void forget_decisions();
  /// Calls tell(lane, low) for each lane that acts on block b, in the order of the
  /// list.
  template <class Tell> void each_lane_of(int b, const Tell& tell) const {
    for (int k = high_lanes[b]; k < high_lanes[b + 1]; ++k)
      tell(high_lane[k], false);
    for (int lane = low_lanes[b]; lane < low_lanes[b + 1]; ++lane)
      tell(lane, true);
  }
  /// The lane of the group's contact that acts in this step, or -1.
  int acting(int g) const {
    const int lane = lane_of[g];
    return lane >= 0 && lanes.touch[lane] != apart ? lane : -1;
  }
  /// Springs from the list to the lanes.
  void load(const Blocks& blocks, const Contacts& contacts);
  /// Springs, forces and overlaps from the lanes, or from one, to the list.
  void store(Contacts& contacts);
  void store_lane(Contacts& contacts, int lane) const;
  /// Puts what is decided of a group, and its spring, into its lane. False: it has
  /// none.
  bool set_lane(const Blocks& blocks, const Contacts& contacts, int g);
  /// Makes one of what the threads found.
  void join_shares();
  /// Lists the lanes anew: a group that had none wants one.
  void list_lanes(const Blocks& blocks, Contacts& contacts);
};

/// Splits the list into its groups and pairs, all to be decided. each_alone: one record
/// each, for studies without the nearest edge.
void group_contacts(const Blocks& blocks, const Contacts& contacts, bool rigid,
                    ContactGroups& groups, bool each_alone = false, int threads = 1);

}  // namespace blocks::dynamics
