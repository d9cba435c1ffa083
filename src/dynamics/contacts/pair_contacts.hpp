// The contacts of some pairs, outside the arrays that hold them in a step.
#pragma once

#include <vector>

#include "dynamics/rules/pair_rule.hpp"

namespace blocks::dynamics {

/// A contact of a pair, independent of its slot.
struct PairContact {
  CornerOnEdge at;
  bool tested = false;   ///< it acts if its corner is inside (19) and between the ends
  bool certain = false;  ///< it acts in any case
  bool acted = false;    ///< it acted in the step before
  double normal = 0.0, shear = 0.0;  ///< [F] springs
};

/// Pair pair[k] has the contacts from all[first[k]] to all[first[k + 1]], a half-open
/// range.
struct ContactsOfPairs {
  std::vector<int> pair, first = {0};
  std::vector<PairContact> all;
  void clear() { pair.clear(), first.assign(1, 0), all.clear(); }
  void add(int p, const std::vector<PairContact>& contacts) {
    pair.push_back(p);
    all.insert(all.end(), contacts.begin(), contacts.end());
    first.push_back(static_cast<int>(all.size()));
  }
};

/// The spring of a contact that has ceased to act. It passes to another contact
/// (spring_transfer.hpp).
struct ReleasedSpring {
  int pair;
  CornerOnEdge at;
  double normal, shear;  ///< [F] normal > 0
};

/// The changes that one thread makes when it assigns contacts (ContactArrays::assign).
struct ContactChanges {
  std::vector<ReleasedSpring> released;
  ContactsOfPairs grown;                 ///< pairs with more contacts than slots
  std::vector<PairContact> before, now;  ///< working memory
};

}  // namespace blocks::dynamics
