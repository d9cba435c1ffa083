// Decides pairs of blocks by the kernel of face_kernel.hpp where doubles are certain,
// and tells for how long that holds (docs/contact-rule.md#kept-decisions).
#pragma once

#include <limits>
#include <vector>

#include "dynamics/decisions/decisions.hpp"
#include "dynamics/kernels/face_kernel.hpp"
#include "dynamics/rules/closed_joints.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// What is certain of a pair.
struct CertainDecision {
  /// The contacts that may act. Each acts if its corner is inside its edge (19) and
  /// between the ends of the edge.
  std::vector<CornerOnEdge> contacts;
  /// [L] The decision holds for motions of the two blocks (PairMotion::two) less than
  /// this; 0: it is in doubt.
  double room = 0.0;
  /// [L] Likewise for motions of neighbours; infinite: these do not count.
  double room_of_neighbours = std::numeric_limits<double>::infinity();
};

/// Decides some pairs. Working memory of one thread.
class CertainDecisions {
 public:
  /// Finds what is certain of the pairs that are due, for steps of dt.
  void find(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
            const Decisions& decisions, const std::vector<int>& due, double dt);
  /// The decision of due pair k.
  const CertainDecision& operator[](std::size_t k) const { return decisions_[k]; }

 private:
  /// Two parts of the blocks of due pair `of`.
  struct TwoParts {
    int of, part[2];
  };
  void decide_lanes(const Blocks& blocks, const BlockParts& parts,
                    const PairIndex& index, const Decisions& decisions,
                    const std::vector<int>& due, std::size_t first, double dt);

  std::vector<CertainDecision> decisions_;
  std::vector<TwoParts> two_parts_;
  PartPairs lanes_;
  FacingAnswers answers_;
  JointScratch scratch_;
};

}  // namespace blocks::dynamics
