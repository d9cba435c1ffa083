// The decisions that a run keeps over several steps (docs/kept-decisions.md), judged
// where they were made.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "audit/audit.hpp"

namespace blocks::audit {

class KeptPairs {
 public:
  /// Refers to the blocks of the moment. Copies nothing if it has no kept decisions.
  explicit KeptPairs(const Moment& moment);

  /// Returns the contacts that must act between two blocks now, in ascending order, if
  /// the exact rule decided the pair some time ago and the decision is kept: those that
  /// might act by the exact rule where the blocks were then, and whose corners are now
  /// inside their edges and between the ends. Where that is within rounding, those that
  /// did act.
  std::optional<std::vector<std::pair<int, int>>>
  contacts(const BlockPair& pair, const std::vector<std::pair<int, int>>& acting,
           const ExactPairRule& now) const;

 private:
  /// Returns the blocks where they were when a pair was decided.
  Blocks blocks_at(const std::vector<KeptPose>& poses) const;

  const Blocks& blocks_;
  const std::vector<int>& order_;
  std::map<BlockPair, std::vector<KeptPose>> poses_;  ///< in the deck's numbers
};

}  // namespace blocks::audit
