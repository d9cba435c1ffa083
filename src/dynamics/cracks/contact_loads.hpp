// The contact forces on the blocks that may split between two point loads
// (docs/cracks.md#when-blocks-split).
#pragma once

#include <utility>
#include <vector>

#include "dynamics/cracks/crack_rules.hpp"

namespace blocks::dynamics {

/// Lists the forces of contacts and symmetry planes on each block, in the order of the
/// contacts of the model.
class ContactLoads {
 public:
  /// Forces that cannot split their block are left out: those that are too weak for the
  /// shortest chord, part * sqrt(amin). The model must have been read.
  ContactLoads(const Model& model, double part);

  /// Returns whether block b has at least two of them.
  bool may_crack(int b) const;
  std::vector<PointLoad> of(int b) const;

 private:
  std::vector<std::pair<int, PointLoad>> loads_;  ///< ascending in block
};

}  // namespace blocks::dynamics
