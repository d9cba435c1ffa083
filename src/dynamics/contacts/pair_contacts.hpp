// The contacts of some pairs, outside the arrays that hold them in a step.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "dynamics/rules/pair_rule.hpp"
#include "model/contacts.hpp"

namespace blocks::dynamics {

/// A contact of a pair, independent of its slot.
struct ContactRecord {
  CornerOnEdge at;
  bool tested = false;   ///< it acts if its corner is inside (19) and between the ends
  bool certain = false;  ///< it acts in any case
  bool acted = false;    ///< it acted in the step before
  double normal = 0.0, shear = 0.0;  ///< [F] springs
};

/// The same with the state of its law.
struct PairContact : ContactRecord {
  LawState law_state = {};

  /// Returns whether the contact may go on acting without being found by the contact
  /// rule: the kernel decides (find_acting_or_held).
  bool may_be_held() const {
    return acted && (law_state.bonded || law_state.offset > 0.0);
  }
};

/// Adds a contact without springs to a list in ascending order of corner and edge,
/// unless it is there already.
inline void add_in_order(std::vector<PairContact>& contacts, const CornerOnEdge& at) {
  const auto place = std::lower_bound(
      contacts.begin(), contacts.end(), at,
      [](const PairContact& l, const CornerOnEdge& r) { return l.at < r; });
  if (place == contacts.end() || place->at != at)
    contacts.insert(place, PairContact{{.at = at}});
}

/// Pair pair[k] has the contacts from all[first[k]] to all[first[k + 1]], a half-open
/// range.
struct ContactsOfPairs {
  std::vector<int> pair, first = {0};
  std::vector<ContactRecord> all;
  std::vector<LawState> law_states;  ///< (all); empty if laws are LawTable::none

  void clear() { pair.clear(), first.assign(1, 0), all.clear(), law_states.clear(); }
  /// Adds contacts of pair p. with_laws: contacts have a LawState (LawTable::none is
  /// false).
  void add(int p, const std::vector<PairContact>& contacts, bool with_laws) {
    pair.push_back(p);
    for (const PairContact& contact : contacts) {
      all.push_back(contact);
      if (with_laws)
        law_states.push_back(contact.law_state);
    }
    first.push_back(static_cast<int>(all.size()));
  }
  /// Adds all contacts of another list.
  void append(ContactsOfPairs&& other) {
    if (pair.empty()) {
      *this = std::move(other);
      return;
    }
    const int before = static_cast<int>(all.size());
    const auto copy = [](const auto& from, auto& to) {
      to.insert(to.end(), from.begin(), from.end());
    };
    copy(other.pair, pair), copy(other.all, all), copy(other.law_states, law_states);
    for (std::size_t k = 1; k < other.first.size(); ++k)
      first.push_back(before + other.first[k]);
  }
  PairContact at(std::size_t i) const {
    return {all[i], law_states.empty() ? LawState{} : law_states[i]};
  }
};

/// A copy of the spring of a contact that has ceased to act, or that a new decision
/// lacks. It passes to another contact (spring_transfer.hpp).
struct ReleasedSpring {
  int pair;
  CornerOnEdge at;
  double normal, shear;     ///< [F] normal > 0
  LawState law_state = {};  ///< of the contact; empty if LawTable::none
};

/// The changes that one thread makes when it assigns contacts (ContactArrays::assign).
struct ContactChanges {
  std::vector<ReleasedSpring> released;
  ContactsOfPairs grown;                 ///< pairs with more contacts than slots
  std::vector<PairContact> before, now;  ///< working memory
};

}  // namespace blocks::dynamics
