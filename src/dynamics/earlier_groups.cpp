#include "dynamics/earlier_groups.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "dynamics/give_back.hpp"

namespace blocks::dynamics {
namespace {

/// Within its pair. A notch has two.
std::int64_t place(const std::vector<int>& corner, const ContactGroup& group) {
  return 2 * std::int64_t{corner[group.first]} + group.of_notch;
}

/// Who has a seat keeps it, unless it will not act for long.
int next_seat(const ContactGroup& group) {
  return group.seat >= 0 && (!group.certain() || group.conditional())
             ? ContactGroup::seat_wanted
             : ContactGroup::no_seat;
}

}  // namespace

void EarlierGroups::clear() {
  give_back(all);
  give_back(pairs);
  give_back(poses);
  give_back(shapes);
  give_back(limits);
  give_back(corner);
  give_back(edge);
  give_back(heirs);
}

void EarlierGroups::take(ContactGroups& groups) {
  // of the next list other blocks may be the third
  groups.thirds.each(
      [&](const ThirdBlock& third) { groups.all[third.group].travel = 0.0F; });
  std::swap<DecidedGroups>(*this, groups);
}

void EarlierGroups::take(Contacts& contacts) {
  corner.swap(contacts.corner);
  edge.swap(contacts.edge);
}

/// The records of the new list from `first` on are all that the pair had, and has.
bool EarlierGroups::has_records(int pair, const Blocks& blocks,
                                const Contacts& contacts, int first) const {
  const RecordRange before = records_of(pair);
  const int last = first + before.last - before.first;
  return last <= contacts.size() &&
         std::equal(corner.begin() + before.first, corner.begin() + before.last,
                    contacts.corner.begin() + first) &&
         std::equal(edge.begin() + before.first, edge.begin() + before.last,
                    contacts.edge.begin() + first) &&
         (last == contacts.size() ||
          pair_of(blocks, contacts, last) != blocks_of(pair));
}

void EarlierGroups::copy_groups(int pair, int first, ContactGroups& groups) const {
  const int to = static_cast<int>(groups.all.size());
  groups.pairs.push_back(
      {.low = pairs[pair].low, .high = pairs[pair].high, .first = to});
  groups.all.insert(groups.all.end(), all.begin() + pairs[pair].first,
                    all.begin() + end_of(pair));
  const int moved = first - records_of(pair).first;
  for (auto group = groups.all.begin() + to; group != groups.all.end(); ++group)
    group->first += moved;
}

void EarlierGroups::find_groups(const Blocks& blocks, const Contacts& contacts,
                                ContactGroups& groups) {
  groups.all.clear();
  groups.pairs.clear();
  heirs.clear();
  const int count = static_cast<int>(pairs.size());
  int from = 0, last = 0;
  for (int first = 0; first < contacts.size(); first = last) {
    const auto now = pair_of(blocks, contacts, first);
    while (from < count && blocks_of(from) < now)
      ++from;
    const bool there = from < count && blocks_of(from) == now;
    if (there && has_records(from, blocks, contacts, first)) {
      copy_groups(from, first, groups);
      last = groups.all.back().last();
      heirs.push_back({from, true});
      continue;
    }
    while (last < contacts.size() && pair_of(blocks, contacts, last) == now)
      ++last;
    add_groups(blocks, contacts, {first, last}, groups);
    heirs.push_back({there ? from : -1, false});
  }
}

void EarlierGroups::hand_on(const Contacts& contacts, ContactGroups& groups) const {
  for (int to = 0; to < static_cast<int>(groups.pairs.size()); ++to)
    if (const auto [from, same] = heirs[to]; same)
      hand_on_same(groups, from, to);
    else if (from >= 0)
      hand_on_pair(contacts, groups, from, to);
  std::fill(groups.swing.way.begin(), groups.swing.way.end(), 0.0);
  groups.swing.travel = 0.0;
}

void EarlierGroups::hand_on_same(ContactGroups& groups, int from, int to) const {
  ContactPair& pair = groups.pairs[to];
  pair.prompt = pairs[from].prompt;
  bool complete = true;
  for (int g = pair.first; g < groups.end_of(to); ++g) {
    ContactGroup& group = groups.all[g];
    group.seat = next_seat(group);
    if (group.certain())
      continue;
    complete = complete && group.of_notch != 0U;
    group.forget();
    pair.prompt &= ~pair.bit(g);
  }
  hand_on_pose(groups, from, to, complete);
}

void EarlierGroups::hand_on_pose(ContactGroups& groups, int from, int to,
                                 bool complete) const {
  const ContactPair& pair = groups.pairs[to];
  const Swing& swing = groups.swing;
  groups.poses[to] = poses[from];
  if (!swing.rigid)
    groups.shapes[to] = shapes[from];
  if (complete)
    groups.limits[to] =
        rounded_down(limits[from] - (swing.way[pair.low] + swing.way[pair.high]));
  else
    groups.poses[to].certain = 0.0F;
  if (pair.prompt != 0)
    groups.prompt[to / pairs_of_round] |=
        static_cast<std::uint8_t>(1U << (to % pairs_of_round));
}

void EarlierGroups::hand_on_pair(const Contacts& contacts, ContactGroups& groups,
                                 int from, int to) const {
  const ContactPair& known = pairs[from];
  ContactPair& pair = groups.pairs[to];
  bool complete = true;
  int old = known.first;
  const int end = groups.end_of(to), old_end = end_of(from);
  for (int g = pair.first; g < end; ++g) {
    ContactGroup& group = groups.all[g];
    const std::int64_t wanted = place(contacts.corner, group);
    while (old < old_end && place(corner, all[old]) < wanted)
      ++old;
    const bool there = old < old_end && place(corner, all[old]) == wanted;
    const bool prompt = there && (known.prompt & known.bit(old)) != 0;
    const bool room = !prompt || pair.bit(g) != 0;
    const bool handed = there && room && hand_on_group(contacts, all[old], group);
    complete = complete && handed;
    if (handed && prompt)
      pair.prompt |= pair.bit(g);
  }
  hand_on_pose(groups, from, to, complete);
}

bool EarlierGroups::hand_on_group(const Contacts& contacts, const ContactGroup& from,
                                  ContactGroup& to) const {
  to.hopeless = from.hopeless;
  to.seat = next_seat(from);
  if (!from.certain())
    return from.of_notch != 0U;  // decided with the group before
  const auto edges = edge.begin() + from.first, edges_end = edge.begin() + from.last();
  const auto now = contacts.edge.begin() + to.first;
  const auto now_end = contacts.edge.begin() + to.last();
  if (std::equal(now, now_end, edges, edges_end)) {
    to.nth = from.nth;
  } else {
    if (!std::includes(edges, edges_end, now, now_end))
      return false;
    if (from.record() >= 0) {
      const auto acting = std::find(now, now_end, edge[from.record()]);
      if (acting == now_end)
        return false;
      to.set_record(static_cast<int>(acting - contacts.edge.begin()));
    }
  }
  to.travel = from.travel, to.unasked = from.unasked;
  to.place_from_anywhere = from.place_from_anywhere, to.asks = from.asks;
  to.watched = from.watched;
  return true;
}

}  // namespace blocks::dynamics
