// Adds the contacts that the laws of joints hold to those of the contact rule
// (docs/laws.md#results).
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "audit/audit.hpp"

namespace blocks::audit {

/// A corner and the first corner of an edge.
using CornerEdge = std::pair<int, int>;

/// Returns 1 if a corner that is below an edge by `overlap` [L] is inside it and
/// between its ends, 0 if not, and -1 if that is within rounding.
int is_on_edge(const Blocks& blocks, const CornerEdge& contact, double overlap);

class HeldContacts {
 public:
  /// Keeps the held contacts of the moment, and refers to its blocks.
  explicit HeldContacts(const Moment& moment);

  bool contains(int corner, int edge) const { return held_.contains({corner, edge}); }

  /// Returns the pairs of blocks with held contacts, in ascending order.
  std::vector<BlockPair> pairs() const {
    std::vector<BlockPair> all;
    for (const auto& [pair, contacts] : of_pair_)
      all.push_back(pair);
    return all;
  }

  /// Returns the contacts that must act between two blocks, in ascending order, given
  /// those of the rule and those that acted. Whether dilation still holds a contact is
  /// decided in doubles with a tolerance; within it, the contact may act or not. A
  /// contact at the same end of a face may act after one that has just ended.
  std::vector<CornerEdge> expected(const BlockPair& pair,
                                   const std::vector<CornerEdge>& by_rule,
                                   const std::vector<CornerEdge>& acting,
                                   const ExactPairRule& rule) const;

 private:
  /// Returns 1 if dilation holds the contact, 0 if not, -1 if that is within the
  /// tolerance.
  int holds_open(const CornerEdge& contact, double offset,
                 const ExactPairRule& rule) const;

  /// Returns the contacts that may be at the same end of a face.
  std::array<CornerEdge, 2> at_same_end(const CornerEdge& contact) const;

  const Blocks& blocks_;
  std::map<CornerEdge, HeldContact> held_;
  std::map<BlockPair, std::vector<CornerEdge>> of_pair_;
};

}  // namespace blocks::audit
