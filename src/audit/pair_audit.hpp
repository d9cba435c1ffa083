// Judges the contacts of one moment by the contact rule of pairs of blocks
// (docs/contact-rule.md): whether the list of near pairs is complete and every decision
// is exact.
#pragma once

#include <utility>
#include <vector>

#include "audit/audit.hpp"
#include "audit/exact_pair_rule.hpp"

namespace blocks::audit {

/// The contacts that act between two blocks are not the exact ones.
struct WrongPair {
  int first = 0, second = 0;  ///< first < second
  /// Corner and edge of each contact, in ascending order.
  std::vector<std::pair<int, int>> acting, exact;
};

struct PairFindings {
  long pairs = 0;   ///< pairs of blocks that the list has to hold
  long acting = 0;  ///< acting contacts
  std::vector<std::pair<int, int>> missed;  ///< those that the list lacks
  std::vector<WrongPair> wrong;

  bool sound() const { return missed.empty() && wrong.empty(); }
};

/// The exact rule for these blocks. Its neighbours are all blocks whose bounding boxes,
/// grown by `reach` [L], meet and of which one is free. They need no list: a side that
/// covers lies in part in the block that asks, so any larger set has the same effect.
ExactPairRule exact_rule(const Blocks& blocks, std::vector<ConvexPart> parts,
                         double reach);

/// The parts as geometry::convex_parts cuts the outlines as they are.
std::vector<ConvexPart> cut_into_parts(const Blocks& blocks);

/// Compares the contacts of all pairs of blocks near each other. `listed` has the pairs
/// of the program's list, the lower block first, in ascending order. It has to hold all
/// pairs whose bounding boxes may meet before the next list.
PairFindings audit_pairs(const Moment& moment, std::vector<ConvexPart> parts,
                         const std::vector<std::pair<int, int>>& listed);

}  // namespace blocks::audit
