#include "dynamics/earlier_groups.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

#include "dynamics/give_back.hpp"

namespace blocks::dynamics {
namespace {

/// In the order of a list.
auto place(const ContactPair& pair) { return std::tuple(pair.low, pair.high); }
/// Within its pair. A notch has two.
std::int64_t place(const std::vector<int>& corner, const ContactGroup& group) {
  return 2 * std::int64_t{corner[group.first]} + group.of_notch;
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

void EarlierGroups::hand_on(const Contacts& contacts, ContactGroups& groups) const {
  const int count = static_cast<int>(pairs.size());
  int from = 0;
  for (int to = 0; to < static_cast<int>(groups.pairs.size()); ++to) {
    while (from < count && place(pairs[from]) < place(groups.pairs[to]))
      ++from;
    if (from < count && place(pairs[from]) == place(groups.pairs[to]))
      hand_on_pair(contacts, groups, from, to);
  }
  std::fill(groups.swing.way.begin(), groups.swing.way.end(), 0.0);
  groups.swing.travel = 0.0;
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

bool EarlierGroups::hand_on_group(const Contacts& contacts, const ContactGroup& from,
                                  ContactGroup& to) const {
  to.hopeless = from.hopeless;
  // unless it will not act for long
  if (from.seat >= 0 && (!from.certain() || from.conditional()))
    to.seat = ContactGroup::seat_wanted;
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
