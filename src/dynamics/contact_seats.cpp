// What of ContactGroups has to do with lanes: who has a seat, and springs on their way
// between list and lanes.
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "dynamics/contact_groups.hpp"
#include "dynamics/dashpot.hpp"
#include "dynamics/give_back.hpp"
#include "dynamics/huge_pages.hpp"

namespace blocks::dynamics {
namespace {

/// How it is known whether the group's contact, which has the seat, acts.
void set_rule(ContactLanes& lanes, int seat, const ContactGroup& group) {
  const bool may = group.record() >= 0;
  lanes.set(seat, &SlotPlaces::asked, may && group.certain());
  lanes.set(seat, &SlotPlaces::decided, may && !group.certain());
}

}  // namespace

bool ContactGroups::keep_seat(int g) {
  const int seat = all[g].seat;
  if (seat < 0 || record[seat] != all[g].record())
    return false;
  set_rule(lanes, seat, all[g]);
  return true;
}

bool ContactGroups::set_seat(const Blocks& blocks, const Contacts& contacts, int g,
                             int i, const HeldSpring& spring) {
  const ContactGroup& known = all[g];
  const int seat = all[g].seat;
  if (seat < 0)
    return i < 0;
  const int e = contacts.edge[std::max(i, known.first)];
  record[seat] = i;
  const int slot = seat / lane_count, k = seat % lane_count;
  SlotPlaces& places = lanes.places[slot];
  SlotSprings& springs = lanes.springs[slot];
  places.corner[k] = contacts.corner[known.first];
  places.edge[k] = e;
  places.edge_end[k] = blocks.next[e];
  lanes.set(seat, &SlotPlaces::flips, known.low_edges);
  set_rule(lanes, seat, known);
  lanes.set(seat, &SlotPlaces::touches, spring.record >= 0);
  lanes.set(seat, &SlotPlaces::starts, false);
  springs.normal_elastic[k] = spring.normal;
  springs.shear_elastic[k] = spring.shear;
  return true;
}

HeldSpring ContactGroups::held(int seat) const {
  if (record[seat] < 0 || !lanes.is(seat, &SlotPlaces::touches))
    return {};
  return {record[seat], lanes.at(seat, &SlotSprings::normal_elastic),
          lanes.at(seat, &SlotSprings::shear_elastic)};
}

void ContactGroups::load(const Blocks& blocks, Contacts& contacts,
                         const Settings& settings) {
  const bool anew = lanes.sets() == 0;
  if (anew)
    first_set.assign(1, 0);
  Wake loaded_already(contacts.acting.data());
  auto contact = contacts.acting.cbegin();
  each_window([&](int first, int last) {
    if (anew)
      seat_window(first, last);
    const SetRange sets = sets_of(first);
    for (int set = sets.first; set < sets.last; ++set) {
      LanePairs& two = lanes.pairs[set];
      for (int k = 0; k < lane_count && two.low[k] != two.high[k]; ++k)
        two.damping[k] = contact_damping(settings, blocks, two.low[k], two.high[k]);
    }
    const int begin = pairs[first].first, end = end_of(last - 1);
    for (int g = begin; g < end; ++g)
      if (all[g].seat >= 0)
        set_seat(blocks, contacts, g, all[g].record(), {});
    const int beyond = all[end - 1].last();
    for (int g = begin; contact != contacts.acting.cend() && contact->record < beyond;
         ++contact) {
      contacts.active[contact->record] = false;
      while (all[g].last() <= contact->record)
        ++g;
      load(blocks, contacts, g, *contact);
    }
    loaded_already.passed(contacts.acting.data() +
                          (contact - contacts.acting.cbegin()));
  });
  contacts.acting.clear();
  if (anew) {
    split.split_sets(first_set);
    lows.sort(blocks.size(), pairs, &ContactPair::low);
    highs.sort(blocks.size(), pairs, &ContactPair::high);
  }
  loaded = true;
  read = false;
}

void ContactGroups::load(const Blocks& blocks, const Contacts& contacts, int g,
                         const ActingContact& contact) {
  const int i = contact.record;
  // A notch has two seats. One that holds none takes what has acted until now, and it
  // is found to be lost in this step.
  const auto wanted = [&](int number) {
    for (int of = g; of <= g + static_cast<int>(all[g].reentrant); ++of)
      if (record[all[of].seat] == number)
        return of;
    return -1;
  };
  int own = wanted(i);
  if (own < 0)
    own = wanted(-1);
  if (own >= 0)
    set_seat(blocks, contacts, own, i,
             {i, contact.normal_elastic, contact.shear_elastic});
  else if (contact.normal_elastic > 0.0)
    lost.push_back({g, i, contact.normal_elastic, contact.shear_elastic});
}

void ContactGroups::store(Contacts& contacts, int g, bool with_readings) const {
  const int seat = all[g].seat, slot = seat / lane_count, k = seat % lane_count;
  const SlotSprings& springs =
      with_readings ? lanes.advanced[slot] : lanes.springs[slot];
  ActingContact& contact = contacts.acting.emplace_back();
  contact.record = record[seat];
  contact.normal_elastic = springs.normal_elastic[k];
  contact.shear_elastic = springs.shear_elastic[k];
  if (with_readings) {
    const SlotReadings& reading = lanes.readings[slot - lanes.first_reading];
    contact.normal_force = reading.normal_force[k];
    contact.shear_force = reading.shear_force[k];
    contact.overlap = reading.overlap[k];
  }
  contacts.active[contact.record] = true;
  // the two seats of a notch hold records of the same range
  if (auto last = contacts.acting.end() - 1;
      last != contacts.acting.begin() && last->record < (last - 1)->record)
    std::iter_swap(last, last - 1);
}

void ContactGroups::store(Contacts& contacts) {
  if (!loaded)
    return;
  StoredLanes stored(lanes);
  each_window([&](int first, int last) {
    const int end = end_of(last - 1);
    for (int g = pairs[first].first; g < end; ++g)
      if (all[g].seat >= 0 && held(all[g].seat).record >= 0)
        store(contacts, g, false);
    stored.passed(sets_of(first).last);
  });
  loaded = false;
}

StoredLanes::StoredLanes(const ContactLanes& lanes)
    : lanes_(lanes), places_(lanes.places), springs_(lanes.springs),
      advanced_(lanes.advanced) {}

void StoredLanes::passed(int set) {
  if (set == 0)
    return;
  const int slot = lanes_.pairs[set - 1].first_slot + lanes_.pairs[set - 1].slots;
  places_.passed(lanes_.places + slot);
  springs_.passed(lanes_.springs + slot);
  advanced_.passed(lanes_.advanced + slot);
}

int ContactGroups::group_of(int seat) const {
  const auto after = std::upper_bound(
      all.begin(), all.end(), record[seat],
      [](int i, const ContactGroup& group) { return i < group.first; });
  const int g = static_cast<int>(after - all.begin()) - 1;
  return all[g].seat == seat ? g : g - 1;  // a notch has two
}

void ContactGroups::make_lanes(const Contacts& contacts) {
  // Until two blocks have gone as far again as since lanes were made, of their ways
  // what the travel has grown by; not at first, for most of those who are near in a
  // wall at rest never act.
  const double since =
      times_made > 0 && swing.travel > 0.0 ? 1.0 - made_at / swing.travel : 0.0;
  ++times_made;
  made_at = swing.travel;
  const auto may_act_soon = [&](const ContactPair& pair, int g) {
    const double soon = since * (swing.way[pair.low] + swing.way[pair.high]);
    if ((pair.prompt & pair.bit(g)) != 0)
      return soon > 0.0;
    const ContactGroup& one = all[g];
    return one.certain() ? one.lasts() < soon : soon > 0.0 && one.hopeless > 0;
  };
  auto contact = contacts.acting.cbegin();
  const auto acted = [&](const ContactGroup& group) {  // one group after the other
    while (contact != contacts.acting.cend() && contact->record < group.first)
      ++contact;
    return contact != contacts.acting.cend() && contact->record < group.last();
  };
  for (int p = 0; p < static_cast<int>(pairs.size()); ++p) {
    int& seats = pairs[p].lane;  // so many, until the pair has a lane
    seats = 0;
    for (int g = pairs[p].first, end = end_of(p); g < end; ++g) {
      // who had a seat keeps it: it may want it again
      const bool wants = acted(all[g]) || all[g].seat != ContactGroup::no_seat ||
                         all[g].record() >= 0 || may_act_soon(pairs[p], g);
      all[g].seat = wants ? 0 : ContactGroup::no_seat;
      seats += wants;
      // of a notch both or none: a spring may pass from one to the other
      if (all[g].of_notch && all[g].seat != all[g - 1].seat) {
        all[g].seat = all[g - 1].seat = 0;
        ++seats;
      }
    }
  }
  lanes.clear();
  seats_complete = true;
}

void ContactGroups::seat_window(int first, int last) {
  struct Wish {
    int contacts, pair;
  };
  std::array<Wish, pairs_of_window> wishes;
  int count = 0;
  for (int p = first; p < last; ++p) {
    const int seats = std::exchange(pairs[p].lane, -1);
    if (seats > 0)
      wishes[count++] = {seats, p};
  }
  std::sort(wishes.begin(), wishes.begin() + count, [](const Wish& l, const Wish& r) {
    return l.contacts != r.contacts ? l.contacts > r.contacts : l.pair < r.pair;
  });
  for (int i = 0; i < count; ++i) {
    ContactPair& pair = pairs[wishes[i].pair];
    const int k = i % lane_count;
    if (k == 0)
      lanes.add_set(wishes[i].contacts);
    const int set = lanes.sets() - 1;
    record.resize(static_cast<std::size_t>(lanes.slots()) * lane_count, -1);
    lanes.pairs[set].low[k] = pair.low, lanes.pairs[set].high[k] = pair.high;
    pair.lane = set * lane_count + k;
    int seat = lanes.pairs[set].first_slot * lane_count + k;
    for (int g = pair.first; g < end_of(wishes[i].pair); ++g)
      if (all[g].seat >= 0)
        all[g].seat = std::exchange(seat, seat + lane_count);
  }
  first_set.push_back(lanes.sets());
}

void ContactGroups::reserve_lanes(bool rigid) {
  ContactLanes::Room room;
  each_window([&](int first, int last) {
    int sum = 0, most = 0;
    for (int p = first; p < last; ++p) {
      const int own = end_of(p) - pairs[p].first;
      sum += own, most = std::max(most, own);
    }
    // by size: no set but the first has more slots than each pair of that before
    const int sets = (last - first + lane_count - 1) / lane_count;
    const int slots = sum / lane_count + most;
    room.sets += sets, room.slots += slots;
    room.read_sets = std::max(room.read_sets, sets);
    room.read_slots = std::max(room.read_slots, slots);
  });
  lanes.reserve(room, rigid);
  record.reserve(static_cast<std::size_t>(room.slots) * lane_count);
  first_set.reserve(pairs.size() / pairs_of_window + 2);
  for (LanesOfBlocks* of : {&lows, &highs})
    reserve_pages(of->lane, pairs.size());
}

}  // namespace blocks::dynamics
