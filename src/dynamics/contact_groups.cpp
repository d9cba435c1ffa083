#include "dynamics/contact_groups.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "dynamics/earlier_groups.hpp"
#include "dynamics/huge_pages.hpp"

namespace blocks::dynamics {
namespace {

/// Calls visit(first, last, corner's block, edges' block) for records of one corner and
/// edges of one block, which stand side by side; each_alone: for each record.
template <class Visit>
void each_group(const Blocks& blocks, const Contacts& contacts, RecordRange records,
                bool each_alone, const Visit& visit) {
  const int size = records.last;
  for (int first = records.first, last; first < size; first = last) {
    const int corner = contacts.corner[first];
    const int block = blocks.corner_block[contacts.edge[first]];
    const int begin = blocks.first_corner[block], end = blocks.first_corner[block + 1];
    last = first + 1;
    while (!each_alone && last < size && contacts.corner[last] == corner &&
           contacts.edge[last] >= begin && contacts.edge[last] < end)
      ++last;
    visit(first, last, blocks.corner_block[corner], block);
  }
}

bool notched(const Blocks& blocks, int block, bool each_alone) {
  return !each_alone && !blocks.convex[block];
}

/// each_alone: one record to a group.
void find_groups(const Blocks& blocks, const Contacts& contacts, bool each_alone,
                 ContactGroups& groups) {
  // counted first: of many there is no room for more than there are
  const RecordRange all = {0, contacts.size()};
  std::size_t count = 0, pair_count = 0;
  std::pair<int, int> before(-1, -1);
  each_group(blocks, contacts, all, each_alone, [&](int, int, int own, int block) {
    count += notched(blocks, block, each_alone) ? 2 : 1;
    const std::pair<int, int> pair = std::minmax(own, block);
    pair_count += std::exchange(before, pair) != pair;
  });
  groups.all.clear();
  reserve_pages(groups.all, count);
  groups.pairs.clear();
  reserve_pages(groups.pairs, pair_count);
  add_groups(blocks, contacts, all, groups, each_alone);
}

void find_pairs_of_corners(const Blocks& blocks, const Contacts& contacts,
                           ContactGroups& groups) {
  // groups of a corner in a pair stand side by side
  const auto each = [&](const auto& visit) {
    for (int p = 0; p < static_cast<int>(groups.pairs.size()); ++p)
      for (int g = groups.pairs[p].first, before = -1; g < groups.end_of(p); ++g) {
        const int corner = contacts.corner[groups.all[g].first];
        if (corner != before)
          visit(corner, p);
        before = corner;
      }
  };
  std::vector<int>& first = groups.first_of_corner;
  first.assign(blocks.corners() + 1, 0);
  each([&](int corner, int) { ++first[corner + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  groups.pairs_of_corners.resize(first.back());
  each([&](int corner, int p) { groups.pairs_of_corners[first[corner]++] = p; });
  // each was moved on to where the next begins
  std::move_backward(first.begin(), first.end() - 1, first.end());
  first[0] = 0;
}

}  // namespace

void add_groups(const Blocks& blocks, const Contacts& contacts, RecordRange records,
                ContactGroups& groups, bool each_alone) {
  const auto add = [&](int first, int last, int own, int block) {
    const auto [low, high] = std::minmax(own, block);
    if (groups.pairs.empty() || groups.pairs.back().low != low ||
        groups.pairs.back().high != high)
      groups.pairs.push_back(
          {.low = low, .high = high, .first = static_cast<int>(groups.all.size())});
    ContactGroup group;
    group.first = first;
    group.count = static_cast<std::uint32_t>(last - first) & ContactGroup::most_records;
    group.low_edges = block < own;
    group.reentrant = notched(blocks, block, each_alone);
    groups.all.push_back(group);
    if (group.reentrant) {
      group.reentrant = 0, group.of_notch = 1;
      groups.all.push_back(group);
    }
  };
  each_group(blocks, contacts, records, each_alone, add);
}

void ContactGroup::forget() {
  nth = 0;
  travel = unasked = 0.0F;
  place_from_anywhere = 0, watched = 0;
  asks = 0;
}

void ContactGroup::set(const Certainty& known) {
  set_record(known.candidate);
  travel = unasked = rounded_down(known.travel);
  place_from_anywhere = static_cast<unsigned>(known.place - Certainty::anywhere) & 63U;
  asks = known.asks;
}

WatchedEdges ContactGroups::watched_by(const ContactPair& pair) const {
  WatchedEdges found;
  found.prompt = pair.prompt;
  for (std::uint32_t bits = pair.prompt; bits != 0; bits &= bits - 1) {
    const int k = std::countr_zero(bits);
    const ContactGroup& group = all[pair.first + k];
    found.of[k] = group.place_from_anywhere << Watch::bits | group.watched;
  }
  return found;
}

bool ContactGroups::watch_thirds(const Blocks& blocks, int p, int g,
                                 const ThirdsAway& away) {
  bool room = true;
  // none that is asked: of the next list some may be listed where none are now
  if (away.count > 0)
    room = thirds.add(p / pairs_of_window, {g, p, away.places[0], pairs[p].low,
                                            std::numeric_limits<float>::infinity()});
  for (int k = 0; k < away.count; ++k)
    each_third(blocks, away.places[k], [&](int third) {
      room =
          room && thirds.add(p / pairs_of_window, {g, p, away.places[k], third, 0.0F});
    });
  if (!room)
    thirds.drop(p / pairs_of_window, g);
  return room;
}

void ContactGroups::take_pose(const Blocks& blocks, int pair) {
  const int low = pairs[pair].low, high = pairs[pair].high;
  poses[pair] = {.x = blocks.centroid(0, low) - blocks.centroid(0, high),
                 .y = blocks.centroid(1, low) - blocks.centroid(1, high),
                 .angle_low = blocks.angle[low],
                 .angle_high = blocks.angle[high],
                 .sum = rounded_down(swing.sum[low] + swing.sum[high]),
                 .certain = poses[pair].certain};
  if (!swing.rigid)
    shapes[pair] = {swing.shape.col(low), swing.shape.col(high)};
}

double ContactGroups::relative_motion(const Blocks& blocks, int pair) const {
  const int low = pairs[pair].low, high = pairs[pair].high;
  const PairPose& pose = poses[pair];
  const double x = blocks.centroid(0, low) - blocks.centroid(0, high) - pose.x;
  const double y = blocks.centroid(1, low) - blocks.centroid(1, high) - pose.y;
  double arm_low = 0.0, arm_high = 0.0;
  if (swing.rigid) {
    arm_low = swing.longest[low] * std::abs(blocks.angle[low] - pose.angle_low);
    arm_high = swing.longest[high] * std::abs(blocks.angle[high] - pose.angle_high);
  } else {
    arm_low = swing.reshaped(low, shapes[pair].low);
    arm_high = swing.reshaped(high, shapes[pair].high);
  }
  const double rounded = swing.sum[low] + swing.sum[high] - pose.sum;
  return std::sqrt(x * x + y * y) +
         2.0 * ((arm_low > arm_high ? arm_low : arm_high) + rounded);
}

void ContactGroups::give_back() {
  *this = {};
  give_back_what_is_free();
}

void ContactGroups::forget_decisions() {
  for (ContactPair& pair : pairs)
    pair.prompt = 0;
  for (PairPose& pose : poses)
    pose.certain = 0.0F;
  std::fill(prompt.begin(), prompt.end(), std::uint8_t{0});
  watches.forget();
  thirds.forget();
  std::fill(limits.begin(), limits.end(), 0.0F);
  std::fill(rounds.begin(), rounds.end(), 0.0);
  for (ContactGroup& each : all)
    each.travel = 0.0F, each.hopeless = 1;
}

void ContactGroups::join_shares() {
  for (Share& share : shares) {
    lost.insert(lost.end(), share.lost.begin(), share.lost.end());
    seats_complete = seats_complete && share.seats_complete;
    share.lost.clear();
    share.seats_complete = true;
  }
}

void group_contacts(const Blocks& blocks, const Contacts& contacts, bool rigid,
                    ContactGroups& groups, bool each_alone, int threads,
                    EarlierGroups* earlier) {
  const bool handed = earlier != nullptr && !earlier->empty();
  if (handed)
    earlier->find_groups(blocks, contacts, groups);
  else
    find_groups(blocks, contacts, each_alone, groups);
  find_pairs_of_corners(blocks, contacts, groups);
  reserve_pages(groups.limits, groups.pairs.size());
  groups.limits.assign(groups.pairs.size(), 0.0F);
  groups.rounds.assign((groups.pairs.size() + pairs_of_round - 1) / pairs_of_round,
                       0.0);
  groups.prompt.assign(groups.rounds.size(), 0);
  groups.watches.reserve(static_cast<int>(groups.rounds.size()), rounds_of_window);
  groups.thirds.reserve(static_cast<int>(groups.pairs.size()) / pairs_of_window + 1);
  groups.reserve_lanes(rigid);
  groups.times_made = 0;
  groups.loaded = groups.read = false;
  groups.lost.clear();
  groups.lost.reserve(groups.all.size());
  groups.heirs.reserve(groups.all.size());
  groups.split.start(blocks.size(), groups.pairs, pairs_of_window, threads);
  groups.shares.resize(threads);
  for (ContactGroups::Share& share : groups.shares) {
    share.lost.clear();
    share.lost.reserve(groups.all.size() / threads + 64);
  }
  reserve_pages(groups.poses, groups.pairs.size());
  groups.poses.assign(groups.pairs.size(), {});
  groups.shapes.assign(rigid ? 0 : groups.pairs.size(), {});
  if (handed)
    earlier->hand_on(contacts, groups);
  else
    groups.swing.start(blocks, rigid);
  groups.lanes.clear();
}

}  // namespace blocks::dynamics
