// What follows from a decision, whatever rule made it: the records that act get their
// seats, and springs of records that act no more are lost.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/contact_groups.hpp"

namespace blocks::dynamics::detail {

/// Puts what acts in group g, or may act, into its seat; `other`: and into that of the
/// group after it, which is for the second edge of a notch. Springs of records that do
/// so no more are lost.
inline void seat_records(const Blocks& blocks, const Contacts& contacts,
                         ContactGroups& groups, int g, int other,
                         ContactGroups::Share& share) {
  ContactGroup& group = groups.all[g];
  const int one = group.record();
  if (!group.reentrant && groups.keep_seat(g))
    return;
  if (group.reentrant)
    groups.all[g + 1].set_record(other);
  std::array<HeldSpring, 2> held;
  for (int k = 0; k <= group.reentrant; ++k)
    if (const int seat = groups.all[g + k].seat; seat >= 0)
      held[k] = groups.held(seat);
  const auto spring_of = [&](int i) {
    return i < 0                 ? HeldSpring{}
           : held[0].record == i ? held[0]
           : held[1].record == i ? held[1]
                                 : HeldSpring{};
  };
  for (int k = 0; k <= group.reentrant; ++k) {
    const int i = groups.all[g + k].record();
    share.seats_complete &= groups.set_seat(blocks, contacts, g + k, i, spring_of(i));
  }
  // who acts no more: its forces are gone, its spring may find an heir
  for (const HeldSpring& spring : held)
    if (spring.record != one && spring.record != other && spring.normal > 0.0)
      share.lost.push_back({g, spring.record, spring.normal, spring.shear});
}

}  // namespace blocks::dynamics::detail
