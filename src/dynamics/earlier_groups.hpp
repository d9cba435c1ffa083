// What is still known when a list of contacts is brought up to date: decisions of pairs
// of blocks whose records are those of the list before.
#pragma once

#include <vector>

#include "dynamics/contact_groups.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// The groups of the list before, and their records, while the next is made: of the
/// same blocks, on which nothing but steps has acted since those groups were made.
struct EarlierGroups : private DecidedGroups {
  bool empty() const { return all.empty(); }
  /// None, from now on; gives the memory of many back.
  void clear();
  /// Takes them from those who have to be made anew, but for their swing.
  void take(ContactGroups& groups);
  /// Takes the records of the list, which has to be filled anew.
  void take(Contacts& contacts);
  /// Hands on to the groups of the new list, which know nothing yet, what is certain of
  /// theirs: to a group whose edges were all there before, with the one that acts or is
  /// a candidate to; an edge that is listed no more cannot act before the next list.
  /// Ways (Swing) begin anew.
  void hand_on(const Contacts& contacts, ContactGroups& groups) const;

 private:
  void hand_on_pair(const Contacts& contacts, ContactGroups& groups, int from,
                    int to) const;
  /// False: nothing is certain.
  bool hand_on_group(const Contacts& contacts, const ContactGroup& from,
                     ContactGroup& to) const;

  std::vector<int> corner, edge;  ///< of the records
};

}  // namespace blocks::dynamics
