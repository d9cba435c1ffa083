#include "dynamics/contact_groups.hpp"

#include <algorithm>
#include <numeric>

namespace blocks::dynamics {
namespace {

void find_pairs(ContactGroups& groups) {
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
  way.assign(blocks.size(), 0.0);
  if (!rigid)
    return;
  // no chord is longer than its arc; a little more for the roots
  for (int c = 0; c < blocks.corners(); ++c) {
    double& most = per_radian[blocks.corner_block[c]];
    most = std::max(most, 1.0001 * blocks.arm.col(c).norm());
  }
}

namespace {

/// The record that acts or is the candidate to.
int live_record(const ContactGroup& group) {
  return group.certain.travel > 0.0 ? group.certain.candidate : group.acting;
}

/// Whether the list says that a record of the group acts.
bool acted(const Contacts& contacts, const ContactGroup& group) {
  return std::any_of(contacts.active.begin() + group.first,
                     contacts.active.begin() + group.last, [](char a) { return a; });
}

/// Which lanes act on each block. The list is ordered by the lower block of each pair.
void sort_by_block(int blocks, ContactGroups& groups) {
  const auto each = [&](const auto& tell) {
    for (int lane = 0; lane < groups.lanes.size(); ++lane) {
      const ContactGroup& group = groups.all[groups.group[lane]];
      tell(lane, std::minmax(group.corner_block, group.edge_block));
    }
  };
  std::vector<int>&low = groups.low_lanes, &high = groups.high_lanes;
  low.assign(blocks + 1, 0);
  high.assign(blocks + 1, 0);
  each([&](int, const auto& pair) { ++low[pair.first + 1], ++high[pair.second + 1]; });
  std::partial_sum(low.begin(), low.end(), low.begin());
  std::partial_sum(high.begin(), high.end(), high.begin());
  groups.high_lane.resize(groups.lanes.size());
  each([&](int lane, const auto& pair) {
    groups.high_lane[high[pair.second]++] = lane;
  });
  // each was moved on to where the next begins
  std::move_backward(high.begin(), high.end() - 1, high.end());
  high[0] = 0;
}

}  // namespace

bool ContactGroups::set_lane(const Blocks& blocks, const Contacts& contacts, int g) {
  const ContactGroup& known = all[g];
  const int lane = lane_of[g], i = live_record(known);
  if (lane < 0)
    return i < 0;
  const int e = contacts.edge[std::max(i, known.first)];
  record[lane] = i;
  group[lane] = g;
  lanes.corner[lane] = contacts.corner[known.first];
  lanes.edge[lane] = e;
  lanes.edge_end[lane] = blocks.next[e];
  lanes.corner_block[lane] = known.corner_block;
  lanes.edge_block[lane] = known.edge_block;
  lanes.rule[lane] = i < 0 ? idle : known.certain.travel > 0.0 ? by_sign : decided;
  lanes.damping[lane] = i < 0 ? 0.0 : contacts.damping[i];
  lanes.normal_elastic[lane] = i < 0 ? 0.0 : contacts.normal_elastic[i];
  lanes.shear_elastic[lane] = i < 0 ? 0.0 : contacts.shear_elastic[i];
  lanes.touch[lane] = i >= 0 && contacts.active[i] ? in_touch : apart;
  return true;
}

void ContactGroups::forget_decisions() {
  for (ContactPair& pair : pairs)
    pair.certain = 0.0;
  for (PairWatch& each : watch)
    each.limit = 0.0;
  for (ContactGroup& each : all)
    each.certain.travel = 0.0, each.hopeless = 1;
}

void ContactGroups::store_lane(Contacts& contacts, int lane) const {
  const int i = record[lane];
  if (i < 0)
    return;
  contacts.active[i] = lanes.touch[lane] != apart;
  contacts.normal_elastic[i] = lanes.normal_elastic[lane];
  contacts.shear_elastic[i] = lanes.shear_elastic[lane];
  contacts.normal_force[i] = lanes.normal_force[lane];
  contacts.shear_force[i] = lanes.shear_force[lane];
  contacts.overlap[i] = lanes.overlap[lane];
}

void ContactGroups::load(const Blocks& blocks, const Contacts& contacts) {
  for (int lane = 0; lane < lanes.size(); ++lane)
    set_lane(blocks, contacts, group[lane]);
  loaded = true;
}

void ContactGroups::store(Contacts& contacts) {
  for (int lane = 0; loaded && lane < lanes.size(); ++lane)
    store_lane(contacts, lane);
  loaded = false;
}

void ContactGroups::join_shares() {
  for (Share& share : shares) {
    lost.insert(lost.end(), share.lost.begin(), share.lost.end());
    lanes_complete = lanes_complete && share.lanes_complete;
    share.lost.clear();
    share.lanes_complete = true;
  }
}

void ContactGroups::list_lanes(const Blocks& blocks, Contacts& contacts) {
  store(contacts);
  group.clear();
  const int count = static_cast<int>(all.size());
  for (int g = 0; g < count; ++g) {
    // who had a lane keeps it: it may want it again
    if (lane_of[g] < 0 && live_record(all[g]) < 0 && !acted(contacts, all[g]))
      continue;
    lane_of[g] = static_cast<int>(group.size());
    group.push_back(g);
  }
  lanes.resize(static_cast<int>(group.size()));
  record.assign(group.size(), -1);
  sort_by_block(blocks.size(), *this);
  load(blocks, contacts);
  lanes_complete = true;
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
  find_pairs(groups);
  sort_by_corner(blocks, contacts, groups);
  groups.lane_of.assign(groups.all.size(), -1);
  groups.low_lanes.assign(blocks.size() + 1, 0);
  groups.high_lanes.assign(blocks.size() + 1, 0);
  groups.watch.clear();
  for (const ContactPair& pair : groups.pairs)
    groups.watch.push_back({0.0, pair.low, pair.high});
  const std::size_t most = groups.all.size();
  groups.lanes.reserve(static_cast<int>(most));
  groups.lanes.resize(0);
  for (std::vector<int>* row : {&groups.group, &groups.record, &groups.high_lane})
    row->clear(), row->reserve(most);
  groups.lanes_complete = groups.loaded = false;
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
