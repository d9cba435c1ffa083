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
  // no chord is longer than its arc; a little more for the roots
  for (int c = 0; c < blocks.corners(); ++c) {
    double& most = per_radian[blocks.corner_block[c]];
    most = std::max(most, 1.0001 * blocks.arm.col(c).norm());
  }
}

namespace {

int live_record(const ContactGroup& group) {
  return group.certain.travel > 0.0 ? group.certain.candidate : group.acting;
}

LiveContact live_contact(const Blocks& blocks, const Contacts& contacts,
                         const ContactGroup& group, int g, int pair, int low) {
  const int i = live_record(group), e = contacts.edge[std::max(i, group.first)];
  LiveContact live;
  live.record = i, live.group = g, live.pair = pair;
  live.corner = contacts.corner[group.first], live.edge = e,
  live.edge_end = blocks.next[e];
  live.corner_block = group.corner_block, live.edge_block = group.edge_block;
  live.by_sign = group.certain.travel > 0.0;
  live.acts = i >= 0 && !live.by_sign;
  live.corner_is_low = group.corner_block == low;
  return live;
}

}  // namespace

bool ContactGroups::set_live(const Blocks& blocks, const Contacts& contacts, int g) {
  const ContactGroup& group = all[g];
  const int place = live_of[g];
  if (place >= 0)
    live[place] = live_contact(blocks, contacts, group, g, live[place].pair,
                               pairs[live[place].pair].low);
  return place >= 0 || live_record(group) < 0;
}

void ContactGroups::join_shares() {
  for (Share& share : shares) {
    lost.insert(lost.end(), share.lost.begin(), share.lost.end());
    live_complete = live_complete && share.live_complete;
    share.lost.clear();
    share.live_complete = true;
  }
}

void ContactGroups::list_live(const Blocks& blocks, const Contacts& contacts) {
  live.clear();
  const int count = static_cast<int>(pairs.size());
  for (int p = 0; p < count; ++p)
    for (int g = pairs[p].first; g < pairs[p].last; ++g) {
      // who had a place keeps it: it may want it again
      if (live_of[g] < 0 && live_record(all[g]) < 0)
        continue;
      live_of[g] = static_cast<int>(live.size());
      live.push_back(live_contact(blocks, contacts, all[g], g, p, pairs[p].low));
    }
  live_complete = true;
}

void group_contacts(const Blocks& blocks, const Contacts& contacts, bool rigid,
                    ContactGroups& groups, bool each_alone, int threads) {
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
  groups.live_complete = true;
  groups.lost.clear();
  groups.lost.reserve(groups.all.size());
  groups.shares.resize(threads);
  for (ContactGroups::Share& share : groups.shares) {
    share.lost.clear();
    share.lost.reserve(groups.all.size() / threads + 64);
  }
  groups.swing.start(blocks, rigid);
}

}  // namespace blocks::dynamics
