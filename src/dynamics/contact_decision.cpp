#include "dynamics/contact_decision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::dynamics {

template class ContactDecision<ExactRules>;

int acting_record(const Blocks& blocks, const Contacts& contacts,
                  const ContactGroups& groups, const ContactGroup& group, int block) {
  return ContactDecision<ExactRules>(blocks, contacts, groups)
      .acting_record(group, block);
}

double shield_reach(const Blocks& blocks, int block) {
  double most = 0.0;
  for (int e = blocks.first_corner[block]; e < blocks.first_corner[block + 1]; ++e)
    most = std::max(
        most,
        Vec2(blocks.corner.col(blocks.next[e]) - blocks.corner.col(e)).squaredNorm());
  return shielded_way * std::sqrt(most);
}

}  // namespace blocks::dynamics
