// Records of one corner against the edges of one block, which are decided together
// (rule 12), and how long such a group may be left alone.
#pragma once

#include <vector>

#include "model/model.hpp"

namespace blocks::dynamics {

/// Records first .. last - 1 of the contact list. Working state: not part of the model,
/// and without influence on results.
struct ContactGroup {
  int first = 0, last = 0;
  /// [L] the group cannot act before the accumulated travel since the last search
  /// (UMOST) exceeds this; 0: decide now.
  double asleep_until = 0.0;
};

/// Splits the list into its groups, all awake.
void group_contacts(const Contacts& contacts, std::vector<ContactGroup>& groups);

/// Travel that certainly passes before a corner now outside a convex block gets inside
/// again, [L], or 0. Every corner moves by at most the travel. The corner stands a gap
/// g outside an edge's line, opposite to the point (1 - q) p1 + q p2 of that line,
/// which moves by f = |1 - q| + |q| times the travel u at most. While u (1 + f) <= 0.8
/// g and the edge turns by less than 0.4 rad (u <= 0.2 L), the corner stays outside by
/// more than the slack.
double travel_before_contact(const Blocks& blocks, int corner, int block);

}  // namespace blocks::dynamics
