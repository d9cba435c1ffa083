// Decides pairs of blocks with the kernel of face_kernel.hpp where the rounding of
// doubles cannot change the answer. Also finds how long each decision holds
// (docs/kept-decisions.md).
#pragma once

#include <limits>
#include <vector>

#include "dynamics/decisions/decisions.hpp"
#include "dynamics/kernels/face_kernel.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// The decision of a pair, and how far blocks may move before it can change.
struct CertainDecision {
  /// The contacts that may act. Each acts if its corner is inside its edge (19) and
  /// between the ends of the edge.
  std::vector<CornerOnEdge> contacts;
  /// [L] The validity distance: the decision holds while the motion of the two blocks
  /// is less. If it is 0, the pair is in doubt.
  double validity = 0.0;
  /// [L] The decision holds while MotionBounds::longest_path grows by less than this:
  /// then a neighbour may matter. It is infinite if no neighbour can ever matter.
  double growth = std::numeric_limits<double>::infinity();
};

/// Decides some pairs. Also holds the working memory of one thread.
class CertainDecisions {
 public:
  /// Decides the pairs that are due.
  void find(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
            const Decisions& decisions, const std::vector<int>& due);
  /// Returns the decision of due[k].
  const CertainDecision& operator[](std::size_t k) const { return decisions_[k]; }

 private:
  /// Two convex parts of the blocks of a pair. due: index in the list of pairs.
  struct TwoParts {
    int due, part[2];
  };
  void decide_lanes(const Blocks& blocks, const BlockParts& parts,
                    const PairIndex& index, const Decisions& decisions,
                    const std::vector<int>& due, std::size_t first);

  std::vector<CertainDecision> decisions_;
  std::vector<TwoParts> two_parts_;
  PartPairs lanes_;
  FacingAnswers answers_;
};

}  // namespace blocks::dynamics
