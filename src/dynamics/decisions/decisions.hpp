// Records how long the decision of each pair of blocks holds (docs/kept-decisions.md).
// Checkpoints contain it (kept_state.hpp).
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/decisions/motion_bounds.hpp"
#include "dynamics/rules/block_parts.hpp"
#include "dynamics/search/pair_index.hpp"

namespace blocks::dynamics {

/// The motion on which the decision of a pair depends, or limits of it, [L].
struct PairMotion {
  double two = 0.0;  ///< motion of the two blocks against each other
  /// The same plus the largest motion of a neighbour against one of the two blocks.
  double neighbours = 0.0;
};

/// When a decision of the exact rule has to be made again. Empty for other decisions.
struct Renewal {
  /// Of the two blocks and their neighbours when the decision was made.
  std::vector<KeptPose> poses;
  std::vector<KeptDepth> depths;  ///< depths on which it depends
  /// [L] The motion is certainly below its limit while MotionBounds::most is less than
  /// this.
  double next_check = 0.0;

  bool empty() const { return poses.empty(); }
  void clear() { poses.clear(), depths.clear(); }
};

struct Decisions {
  MotionBounds bounds;
  std::vector<Renewal> renewals;  ///< (pairs)
  /// (pairs) [L] The decision of a pair holds while both motions are below these
  /// limits. The limit for neighbours is infinite if they do not matter.
  std::vector<PairMotion> limits;
  /// (pairs) [L] The decision certainly holds while MotionBounds::most is less than
  /// this.
  std::vector<double> next_check;
  /// The number of spoiled decisions in this phase. A decision is spoiled if the motion
  /// of the phase had used up more than half of its room when it was made.
  long spoiled = 0;
  /// The cost of a spoiled decision, in pairs that are carried over to a new phase. A
  /// spoiled decision is expensive because it soon expires again, until the phase ends.
  /// This value affects run time only.
  static constexpr int cost_of_decision = 64;

  /// Discards all decisions and begins a phase. pairs: the number of pairs.
  void reset(const Blocks& blocks, int pairs);
  /// Keeps the decisions of the old list of pairs in the new one. Discards those that a
  /// new neighbour or a piece of a block may change. changed: whether a block of the
  /// new list is a piece of a block that has split; empty: none is.
  void keep_in(const PairIndex& now, const PairIndex& old,
               const std::vector<char>& changed);
  /// Returns whether the spoiled decisions of the phase cost more than a new phase. If
  /// so, call carry_over() for all pairs and then begin_phase().
  bool phase_is_over() const {
    return spoiled * cost_of_decision > static_cast<long>(limits.size());
  }
  /// Discards the decision of pair p.
  void expire(int p) { limits[p] = {}, next_check[p] = 0.0, renewals[p].clear(); }
  /// Discards the decisions of the exact rule. All others certainly hold.
  void expire_exact() {
    for (std::size_t p = 0; p < renewals.size(); ++p)
      if (!renewals[p].empty())
        expire(static_cast<int>(p));
  }
  /// Keeps the decision of pair p, made now by the exact rule, until one of the depths
  /// leaves its limits, or its blocks and their neighbours have moved against each
  /// other by a part of an arm.
  void keep_exact(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
                  int p, const std::vector<KeptDepth>& depths);
  /// Begins a phase at the current positions of the blocks.
  void begin_phase(const Blocks& blocks);
  /// Keeps the decisions of the pairs [begin, end) in the phase that is about to begin.
  void carry_over(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
                  int begin, int end);

  /// Returns the net motion of pair p since the beginning of the phase, [L]. Without
  /// `neighbours`, only that of its two blocks counts.
  PairMotion motion_of(const Blocks& blocks, const PairIndex& index, int p,
                       bool neighbours) const;
  /// Returns by how much blocks have moved against the first one since they were at
  /// these poses, [L].
  double motion_since(const Blocks& blocks, const std::vector<KeptPose>& kept) const;
  /// Returns the smallest motion of a pair that can take a depth to one of its limits,
  /// [L]; not positive if a depth has passed one.
  double motion_to_limits(const Blocks& blocks, const BlockParts& parts,
                          const std::vector<KeptDepth>& depths) const;
  /// Returns by how much MotionBounds::most may grow before the decision of pair p may
  /// expire, [L]. If the result is not positive, the decision has expired.
  double growth_left(const Blocks& blocks, const BlockParts& parts,
                     const PairIndex& index, int p);
  /// Keeps the decision of pair p, made now, while its motions from now on are less
  /// than `room`. Returns whether the decision is spoiled.
  bool keep(const Blocks& blocks, const PairIndex& index, int p,
            const PairMotion& room);
};

}  // namespace blocks::dynamics
