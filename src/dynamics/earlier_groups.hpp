// What is still known when a list of contacts is brought up to date: decisions of pairs
// of blocks whose records are those of the list before.
#pragma once

#include <utility>
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
  /// Finds the groups of the new list: those of pairs with the same records as before
  /// are copied.
  void find_groups(const Blocks& blocks, const Contacts& contacts,
                   ContactGroups& groups);
  /// Hands on to the groups that were found what is certain of theirs: to a group whose
  /// edges were all there before, with the one that acts or is a candidate to; an edge
  /// that is listed no more cannot act before the next list. Ways (Swing) begin anew.
  void hand_on(const Contacts& contacts, ContactGroups& groups) const;

 private:
  /// Whose a pair of the new list is.
  struct Heir {
    int from;   ///< pair of the list before; -1: it was not there
    bool same;  ///< with the same records
  };
  std::pair<int, int> blocks_of(int pair) const {
    return {pairs[pair].low, pairs[pair].high};
  }
  RecordRange records_of(int pair) const {
    return {all[pairs[pair].first].first, all[end_of(pair) - 1].last()};
  }
  bool has_records(int pair, const Blocks& blocks, const Contacts& contacts,
                   int first) const;
  void copy_groups(int pair, int first, ContactGroups& groups) const;
  void hand_on_pair(const Contacts& contacts, ContactGroups& groups, int from,
                    int to) const;
  void hand_on_same(ContactGroups& groups, int from, int to) const;
  void hand_on_pose(ContactGroups& groups, int from, int to, bool complete) const;
  /// False: nothing is certain.
  bool hand_on_group(const Contacts& contacts, const ContactGroup& from,
                     ContactGroup& to) const;

  std::vector<int> corner, edge;  ///< of the records
  std::vector<Heir> heirs;        ///< (pairs of the new list)
};

}  // namespace blocks::dynamics
