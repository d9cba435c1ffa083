// Records of one corner against the edges of one block, which are decided together
// (rule 12), the pairs of blocks they belong to, and for how long decisions stand.
#pragma once

#include <cmath>
#include <vector>

#include "model/model.hpp"

namespace blocks::dynamics {

/// How far the arms of each block may have turned and strained, beside what its angle
/// tells: no arm has changed by more than `sum` and `per_radian` times the change of
/// the angle.
struct Swing {
  std::vector<double> sum;         ///< (n) [L] grows with every step
  std::vector<double> per_radian;  ///< (n) [L] 0: all is in the sum (deformable blocks)

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

/// A record that acts in this step, or is the candidate to.
struct LiveContact {
  int record = -1;  ///< -1: none any more
  int group = 0, pair = 0;
  int corner = 0, edge = 0, edge_end = 0;
  int corner_block = 0, edge_block = 0;
  bool by_sign = false;  ///< acts if the corner is inside the edge; else it acts
  bool acts = false;
  bool corner_is_low = false;           ///< its block is the pair's low one
  double tangent_x = 0, tangent_y = 0;  ///< unit vector along the edge
  double overlap = 0;                   ///< [L]
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

/// What the contacts of a pair do to one of its blocks: force, moment, f_i x_j.
struct PairForce {
  double x = 0.0, y = 0.0, moment = 0.0;
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
};

/// The groups of a list, and what passes between them. Working state between searches:
/// not part of the model, and without influence on results.
struct ContactGroups {
  std::vector<ContactGroup> all;  ///< in the order of the list
  std::vector<ContactPair> pairs;
  std::vector<int> by_corner;  ///< indices into `all`, corner after corner
  std::vector<int>
      first_of_corner;  ///< (corners + 1) where a corner's begin in by_corner
  // forces of pair p: 2 p on its low block, 2 p + 1 on its high one
  std::vector<int> by_block;        ///< indices into pair_force, block after block
  std::vector<int> first_of_block;  ///< (blocks + 1) where a block's begin in by_block
  std::vector<PairForce> pair_force;

  std::vector<LiveContact> live;  ///< in the order of the groups
  std::vector<int> live_of;       ///< (groups) index into live, -1: none
  bool live_complete = false;     ///< no group lacks a place in it
  std::vector<LostForce> lost;    ///< in this step
  Swing swing;                    ///< of the blocks since the groups were made
  /// What one thread finds.
  struct Share {
    std::vector<LostForce> lost;
    bool live_complete = true;
    Extremes extremes;
    unsigned long long exact_calls = 0;
  };
  std::vector<Share> shares;  ///< (threads)

  /// The contact of a group that acts in this step, or null.
  const LiveContact* acting(int group) const {
    const int i = live_of[group];
    return i >= 0 && live[i].acts ? &live[i] : nullptr;
  }
  /// Puts what is decided of a group into the list of live contacts. False: it has no
  /// place there.
  bool set_live(const Blocks& blocks, const Contacts& contacts, int group);
  /// Makes one of what the threads found.
  void join_shares();
  /// Lists the live contacts anew: one that had no place in the list wants one.
  void list_live(const Blocks& blocks, const Contacts& contacts);
};

/// Splits the list into its groups and pairs, all to be decided. each_alone: one record
/// each, for studies without the nearest edge.
void group_contacts(const Blocks& blocks, const Contacts& contacts, bool rigid,
                    ContactGroups& groups, bool each_alone = false, int threads = 1);

}  // namespace blocks::dynamics
