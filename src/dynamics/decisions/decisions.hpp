// Records how long the decision of each pair of blocks holds (docs/kept-decisions.md).
// Checkpoints contain it (kept_state.hpp).
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/decisions/motion_bounds.hpp"
#include "dynamics/rules/block_parts.hpp"
#include "dynamics/search/pair_index.hpp"
#include "model/kept_decisions.hpp"

namespace blocks::dynamics {

/// When a decision of the exact rule has to be made again. Empty for other decisions.
struct Renewal {
  /// Of the two blocks and their neighbours when the decision was made.
  std::vector<KeptPose> poses;
  std::vector<KeptDepth> depths;  ///< depths on which it depends

  bool empty() const { return poses.empty(); }
  void clear() { poses.clear(), depths.clear(); }
};

/// When a decision has to be examined: not while the paths of its two blocks are
/// together less than `own`, and MotionBounds::most is less than `all`, [L].
struct NextExamination {
  double own = 0.0, all = 0.0;
};

struct Decisions {
  MotionBounds bounds;
  /// (pairs) How long the certain decisions hold; the default for all others.
  std::vector<Room> rooms;
  /// (pairs) When the decisions of the exact rule end; empty for all others.
  std::vector<Renewal> renewals;
  std::vector<NextExamination> next_examination;  ///< (pairs)
  /// (pairs) [L] The same in one number: no path is read while MotionBounds::most is
  /// less than this.
  std::vector<double> next_check;

  /// Discards all decisions. pairs: the number of pairs.
  void reset(int pairs);
  /// Keeps the decisions of the old list of pairs in the new one. Discards those that a
  /// new neighbour may change. Both lists are of the same blocks.
  void keep_in(const PairIndex& now, const PairIndex& old);
  /// Discards the decision of pair p.
  void expire(int p) {
    rooms[p] = {}, renewals[p].clear(), next_examination[p] = {}, next_check[p] = 0.0;
  }
  /// Discards the decisions of the exact rule. All others certainly hold.
  void expire_exact() {
    for (std::size_t p = 0; p < renewals.size(); ++p)
      if (!renewals[p].empty())
        expire(static_cast<int>(p));
  }
  /// Keeps the decision of pair p, made now, while the motion of the two blocks is less
  /// than `room`, [L], and MotionBounds::most has grown by less than `growth`, [L].
  void keep_certain(const Blocks& blocks, const NearPair& pair, int p, double room,
                    double growth);
  /// Keeps the decision of pair p, made now by the exact rule, until one of the depths
  /// leaves its limits, or its blocks and their neighbours have moved against each
  /// other by a part of an arm. The neighbours are the blocks near both or, if
  /// `asked_of_third` (PairScratch), near one of the two.
  void keep_exact(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
                  int p, const std::vector<KeptDepth>& depths, bool asked_of_third);

  /// Returns whether the decision of pair p still holds. Examines it only if it may
  /// have expired since the last time.
  bool holds(const Blocks& blocks, const BlockParts& parts, const NearPair& pair,
             int p);
  /// Returns the motion of the two blocks since a decision was made, [L].
  double motion_since(const Blocks& blocks, const NearPair& pair,
                      const PairPose& then) const;
  /// Returns by how much blocks have moved against the first one since they were at
  /// these poses, [L].
  double motion_since(const Blocks& blocks, const std::vector<KeptPose>& kept) const;
  /// Returns the motion at which a decision of the exact rule about two blocks ends,
  /// [L].
  double renewal_motion(int low, int high) const;
  /// Returns the smallest motion of a pair that can take a depth to one of its limits,
  /// [L]; not positive if a depth has passed one.
  double motion_to_limits(const Blocks& blocks, const BlockParts& parts,
                          const std::vector<KeptDepth>& depths) const;

 private:
  /// Postpones the next examination of pair p until its motion may have grown by
  /// `motion`, or MotionBounds::most has reached `all`, [L].
  void postpone(const NearPair& pair, int p, double motion, double all);
  /// Returns whether the next examination of pair p is still to come; sets next_check.
  bool is_postponed(const NearPair& pair, int p);
};

}  // namespace blocks::dynamics
