#include "dynamics/contact_groups.hpp"

#include <algorithm>
#include <numeric>

namespace blocks::dynamics {
namespace {

void find_pairs(const Blocks& blocks, ContactGroups& groups) {
  groups.pairs.clear();
  const int count = static_cast<int>(groups.all.size());
  for (int g = 0; g < count; ++g) {
    const ContactGroup& group = groups.all[g];
    const auto [low, high] = std::minmax(group.corner_block, group.edge_block);
    if (groups.pairs.empty() || groups.pairs.back().low != low ||
        groups.pairs.back().high != high)
      groups.pairs.push_back({low, high, g, g, 0.0, {}});
    groups.pairs.back().last = g + 1;
  }
  groups.pair_force.assign(2 * groups.pairs.size(), {});

  groups.first_of_block.assign(blocks.size() + 1, 0);
  for (const ContactPair& pair : groups.pairs)
    ++groups.first_of_block[pair.low + 1], ++groups.first_of_block[pair.high + 1];
  std::partial_sum(groups.first_of_block.begin(), groups.first_of_block.end(),
                   groups.first_of_block.begin());
  std::vector<int> next = groups.first_of_block;
  groups.by_block.resize(2 * groups.pairs.size());
  for (int p = 0; p < static_cast<int>(groups.pairs.size()); ++p) {
    groups.by_block[next[groups.pairs[p].low]++] = 2 * p;
    groups.by_block[next[groups.pairs[p].high]++] = 2 * p + 1;
  }
}

void sort_by_corner(const Blocks& blocks, const Contacts& contacts,
                    ContactGroups& groups) {
  groups.first_of_corner.assign(blocks.corners() + 1, 0);
  for (const ContactGroup& group : groups.all)
    ++groups.first_of_corner[contacts.corner[group.first] + 1];
  std::partial_sum(groups.first_of_corner.begin(), groups.first_of_corner.end(),
                   groups.first_of_corner.begin());
  std::vector<int> next = groups.first_of_corner;
  const int count = static_cast<int>(groups.all.size());
  groups.by_corner.resize(count);
  for (int g = 0; g < count; ++g)
    groups.by_corner[next[contacts.corner[groups.all[g].first]]++] = g;
}

}  // namespace

void Swing::start(const Blocks& blocks, bool rigid) {
  sum.assign(blocks.size(), 0.0);
  per_radian.assign(blocks.size(), 0.0);
  if (!rigid)
    return;
  // |dx| + |dy| is at most sqrt 2 times the length of the arc
  for (int c = 0; c < blocks.corners(); ++c) {
    double& most = per_radian[blocks.corner_block[c]];
    most = std::max(most, 1.4143 * blocks.arm.col(c).norm());
  }
}

void ContactGroups::list_live(const Blocks& blocks, const Contacts& contacts) {
  live.clear();
  const int count = static_cast<int>(pairs.size());
  for (int p = 0; p < count; ++p)
    for (int g = pairs[p].first; g < pairs[p].last; ++g) {
      const ContactGroup& group = all[g];
      const bool by_sign = group.certain.travel > 0.0;
      const int i = by_sign ? group.certain.candidate : group.acting;
      live_of[g] = i < 0 ? -1 : static_cast<int>(live.size());
      if (i < 0)
        continue;
      const int e = contacts.edge[i];
      live.push_back({i, g, p, contacts.corner[i], e, blocks.next[e], by_sign, !by_sign,
                      0.0, 0.0, 0.0});
    }
  live_current = true;
}

void group_contacts(const Blocks& blocks, const Contacts& contacts, bool rigid,
                    ContactGroups& groups, bool each_alone) {
  groups.all.clear();
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
    if (group.reentrant) {
      group.reentrant = false, group.of_notch = true;
      groups.all.push_back(group);
    }
  }
  find_pairs(blocks, groups);
  sort_by_corner(blocks, contacts, groups);
  groups.live_of.assign(groups.all.size(), -1);
  groups.live.clear();
  groups.live.reserve(groups.all.size());
  groups.live_current = false;
  groups.lost.clear();
  groups.lost.reserve(size);
  groups.swing.start(blocks, rigid);
}

}  // namespace blocks::dynamics
