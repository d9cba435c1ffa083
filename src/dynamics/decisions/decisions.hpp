// Records how long the decision of each pair of blocks holds (docs/kept-decisions.md).
// Checkpoints contain it (kept_state.hpp).
#pragma once

#include <cstddef>
#include <memory>
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

/// How long the decision of a pair holds. The cheapest question comes first: nothing is
/// read while
///   MotionBounds::longest_path < Decisions::next_check;
/// then the decision is not examined while
///   the sum of the paths of the two blocks < examined_at_pair_path, and
///   MotionBounds::longest_path < examined_at_longest_path;
/// then a certain decision holds while
///   the net motion of the two blocks < validity.distance, and
///   MotionBounds::longest_path < validity.until;
/// and one of the exact rule while its depths are in their limits, and the blocks of
/// its poses have moved by less than Decisions::renewal_motion. All are in [L].
struct PairDecision {
  Validity validity;  ///< of certain decisions; the default for all others
  /// Of decisions of the exact rule; null or empty for all others, which are the most.
  std::unique_ptr<Renewal> renewal;
  double examined_at_pair_path = 0.0, examined_at_longest_path = 0.0;

  bool is_exact() const { return renewal != nullptr && !renewal->empty(); }
  void end_renewal() {
    if (renewal != nullptr)
      renewal->clear();
  }
  /// The decision has to be made again.
  void expire() {
    validity = {}, end_renewal();
    examined_at_pair_path = examined_at_longest_path = 0.0;
  }
};

struct Decisions {
  MotionBounds bounds;
  std::vector<PairDecision> pairs;
  /// (pairs) [L] apart from the rest of a decision, because every step reads it
  std::vector<double> next_check;

  /// Discards all decisions. count: the number of pairs.
  void reset(int count) {
    pairs = std::vector<PairDecision>(static_cast<std::size_t>(count));
    next_check.assign(static_cast<std::size_t>(count), 0.0);
  }
  /// Keeps the decisions of the old list of pairs in the new one. Discards those that a
  /// new neighbour or a piece of a block may change. changed: whether a block of the
  /// new list is a piece of a block that has split; empty: none is.
  void keep_in(const PairIndex& now, const PairIndex& old,
               const std::vector<char>& changed);
  /// Discards the decision of pair p.
  void expire(int p) {
    pairs[p].expire();
    next_check[p] = 0.0;
  }
  /// Discards the decisions of the exact rule. All others certainly hold.
  void expire_exact() {
    for (std::size_t p = 0; p < pairs.size(); ++p)
      if (pairs[p].is_exact())
        expire(static_cast<int>(p));
  }
  /// Keeps the decision of pair p, made now, while the motion of the two blocks is less
  /// than `validity`, [L], and MotionBounds::longest_path has grown by less than
  /// `growth`, [L].
  void keep_certain(const Blocks& blocks, const NearPair& pair, int p, double validity,
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
                      const PairPose& pose) const;
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
  /// `motion`, or MotionBounds::longest_path has reached `longest_path`, [L].
  void postpone(const NearPair& pair, int p, double motion, double longest_path);
  /// Sets next_check. Returns false if pair p has to be examined now.
  bool set_next_check(const NearPair& pair, int p);
};

}  // namespace blocks::dynamics
