// How long the decision of each pair of blocks holds
// (docs/contact-rule.md#kept-decisions). Working state, without influence on results.
#pragma once

#include <vector>

#include "dynamics/decisions/motion_bounds.hpp"
#include "dynamics/search/pair_index.hpp"

namespace blocks::dynamics {

/// The motion that matters to the decision of a pair, or limits of it, [L].
struct PairMotion {
  double two = 0.0;         ///< of its blocks against each other
  double neighbours = 0.0;  ///< of their neighbours against them, both included
};

struct Decisions {
  MotionBounds bounds;
  /// (pairs) The decision of a pair holds while its motion is below these limits.
  /// Infinite: neighbours do not matter.
  std::vector<PairMotion> limits;
  /// (pairs) [L] The decision holds while MotionBounds::most is less.
  std::vector<double> next_check;
  /// Decisions of this phase that lost half of their room, or more, to its motion
  /// before they were made.
  long spoiled = 0;
  /// A spoiled decision costs as much as this many pairs that are carried over to a new
  /// phase: it has to be made again and again until the phase ends.
  static constexpr int cost_of_decision = 64;

  /// Forgets all decisions and begins a phase.
  void forget(const Blocks& blocks, int pairs);
  /// Whether the decisions that the phase has spoiled cost more than a new phase. If
  /// so, `carry_over` all pairs, and then begin a phase.
  bool phase_is_over() const {
    return spoiled * cost_of_decision > static_cast<long>(limits.size());
  }
  void begin_phase(const Blocks& blocks);
  /// Keeps the decisions of pairs begin .. end - 1 for a phase that begins now.
  void carry_over(const Blocks& blocks, const PairIndex& index, int begin, int end);

  /// The net motion of pair p since the beginning of the phase, [L]. Without
  /// `neighbours` only that of its two blocks.
  PairMotion motion_of(const Blocks& blocks, const PairIndex& index, int p,
                       bool neighbours) const;
  /// By how much MotionBounds::most may grow before the decision of pair p may end,
  /// [L]. If it is not positive, the decision has ended.
  double left_of(const Blocks& blocks, const PairIndex& index, int p) const;
  /// The decision of pair p, made now, holds for motions less than these. Returns
  /// whether the motion of the phase until now has spoiled half of one of them.
  bool keep(const Blocks& blocks, const PairIndex& index, int p,
            const PairMotion& room);
};

}  // namespace blocks::dynamics
