#include "dynamics/contact_groups.hpp"

#include <numeric>

namespace blocks::dynamics {

void group_contacts(const Blocks& blocks, const Contacts& contacts,
                    ContactGroups& groups, bool each_alone) {
  groups.all.clear();
  groups.first_of_corner.assign(blocks.corners() + 1, 0);
  const int size = contacts.size();
  for (int first = 0, last; first < size; first = last) {
    last = first + 1;
    while (!each_alone && last < size &&
           contacts.corner[last] == contacts.corner[first] &&
           contacts.edge_block[last] == contacts.edge_block[first])
      ++last;
    ContactGroup group;
    group.first = first, group.last = last;
    group.corner_block = contacts.corner_block[first];
    group.edge_block = contacts.edge_block[first];
    group.reentrant = !each_alone && !blocks.convex[group.edge_block];
    groups.all.push_back(group);
    ++groups.first_of_corner[contacts.corner[first] + 1];
    if (group.reentrant) {
      group.reentrant = false, group.of_notch = true;
      groups.all.push_back(group);
      ++groups.first_of_corner[contacts.corner[first] + 1];
    }
  }
  std::partial_sum(groups.first_of_corner.begin(), groups.first_of_corner.end(),
                   groups.first_of_corner.begin());
  const int count = static_cast<int>(groups.all.size());
  groups.by_corner.resize(count);
  std::vector<int> next = groups.first_of_corner;
  for (int g = 0; g < count; ++g)
    groups.by_corner[next[contacts.corner[groups.all[g].first]]++] = g;
  groups.lost.clear();
  groups.lost.reserve(size);
  groups.swing.assign(blocks.size(), 0.0);
}

void mark_position(const Blocks& blocks, const Swing& swing, ContactGroup& group) {
  const int a = group.corner_block, b = group.edge_block;
  group.offset_x = blocks.centroid(0, a) - blocks.centroid(0, b);
  group.offset_y = blocks.centroid(1, a) - blocks.centroid(1, b);
  group.swing = swing[a] + swing[b];
}

}  // namespace blocks::dynamics
