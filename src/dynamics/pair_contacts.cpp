#include "dynamics/pair_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "dynamics/dashpot.hpp"
#include "geometry/contact_predicates.hpp"
#include "model/contact_blocks.hpp"

namespace blocks::dynamics {
namespace {

auto as_pair(const CornerOnEdge& at) { return std::pair(at.corner, at.edge); }

void index_pairs(const Blocks& blocks, PairContacts& all) {
  std::vector<int>& first = all.first_of_block;
  first.assign(static_cast<std::size_t>(blocks.size()) + 1, 0);
  for (const NearPair& pair : all.pairs)
    ++first[pair.low + 1], ++first[pair.high + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  all.pairs_of_blocks.resize(static_cast<std::size_t>(first.back()));
  for (int p = 0; p < static_cast<int>(all.pairs.size()); ++p)
    for (const int b : {all.pairs[p].low, all.pairs[p].high})
      all.pairs_of_blocks[first[b]++] = p;
  // each was moved on to where the next begins
  std::move_backward(first.begin(), first.end() - 1, first.end());
  first[0] = 0;
}

/// Calls same(old, now) for the pairs that both lists have.
template <class Same>
void each_in_both(const std::vector<NearPair>& old, const std::vector<NearPair>& now,
                  const Same& same) {
  const auto blocks = [](const NearPair& pair) {
    return std::pair(pair.low, pair.high);
  };
  for (std::size_t i = 0, k = 0; i < old.size() && k < now.size();) {
    if (blocks(old[i]) == blocks(now[k]))
      same(static_cast<int>(i++), static_cast<int>(k++));
    else
      ++(blocks(old[i]) < blocks(now[k]) ? i : k);
  }
}

}  // namespace

void ContactsOfPairs::add(int p, const std::vector<PairContact>& contacts) {
  pair.push_back(p);
  all.insert(all.end(), contacts.begin(), contacts.end());
  first.push_back(static_cast<int>(all.size()));
}

void PairContacts::take(std::vector<NearPair>& found, const Blocks& blocks, bool rigid,
                        int threads, bool known, bool moved_only) {
  std::vector<short> next_seats(found.size(), 0);
  if (known) {
    std::size_t k = 0;
    each_in_both(pairs, found, [&](int from, int to) {
      while (k < held.pair.size() && held.pair[k] < from)
        held.pair[k++] = -1;  // it has no spring
      if (k < held.pair.size() && held.pair[k] == from)
        held.pair[k++] = to;
      if (moved_only)
        next_seats[to] = seats[from];
    });
    std::fill(held.pair.begin() + static_cast<std::ptrdiff_t>(k), held.pair.end(), -1);
  }
  if (!moved_only) {
    swing.start(blocks, rigid);
    parts.make(blocks);
  }
  pairs.swap(found);
  seats.swap(next_seats);
  limits.assign(pairs.size(), {});
  rounds.assign((pairs.size() + pairs_of_one_round - 1) / pairs_of_one_round, {});
  index_pairs(blocks, *this);
  shares.resize(static_cast<std::size_t>(threads));
  split.start(blocks.size(), pairs, pairs_of_one_window, threads);
}

void PairContacts::contacts_of(int p, std::vector<PairContact>& contacts) const {
  contacts.clear();
  each_seat(p, [&](int seat) {
    if (is_vacant(seat))
      return;
    const bool touches = lanes.is(seat, &SlotPlaces::touches);
    contacts.push_back({at(seat), lanes.is(seat, &SlotPlaces::asked),
                        lanes.is(seat, &SlotPlaces::decided), touches,
                        touches ? lanes.at(seat, &SlotSprings::normal_elastic) : 0.0,
                        touches ? lanes.at(seat, &SlotSprings::shear_elastic) : 0.0});
  });
}

void PairContacts::take_out(ContactsOfPairs& all) const {
  all.clear();
  std::vector<PairContact> own;
  for (int p = 0; p < static_cast<int>(pairs.size()); ++p)
    if (contacts_of(p, own); !own.empty())
      all.add(p, own);
}

void PairContacts::take_from(const Blocks& blocks, const Contacts& contacts,
                             ContactsOfPairs& all) const {
  all.clear();
  std::vector<PairContact> own;
  int p = 0;
  auto next = contacts.acting.begin();
  while (next != contacts.acting.end()) {
    const auto wanted = pair_of(blocks, contacts, next->record);
    own.clear();
    for (; next != contacts.acting.end() &&
           pair_of(blocks, contacts, next->record) == wanted;
         ++next)
      own.push_back({{contacts.corner[next->record], contacts.edge[next->record]},
                     false,
                     true,
                     true,
                     next->normal_elastic,
                     next->shear_elastic});
    while (p < static_cast<int>(pairs.size()) &&
           std::pair(pairs[p].low, pairs[p].high) < wanted)
      ++p;
    if (p < static_cast<int>(pairs.size()) &&
        std::pair(pairs[p].low, pairs[p].high) == wanted)
      all.add(p, own);
  }
}

void PairContacts::make_sets_of_window(int first, int last) {
  std::array<std::pair<int, int>, pairs_of_one_window> wishes;  // -seats, pair
  int count = 0;
  for (int p = first; p < last; ++p) {
    pairs[p].lane = -1;
    if (seats[p] > 0)
      wishes[count++] = {-seats[p], p};
  }
  std::sort(wishes.begin(), wishes.begin() + count);
  for (int i = 0; i < count; ++i) {
    const int k = i % lane_count;
    if (k == 0)
      lanes.add_set(-wishes[i].first);
    const int set = lanes.sets() - 1;
    NearPair& pair = pairs[wishes[i].second];
    lanes.pairs[set].low[k] = pair.low, lanes.pairs[set].high[k] = pair.high;
    pair.lane = set * lane_count + k;
    pair_of_lane.resize(static_cast<std::size_t>(set + 1) * lane_count, -1);
    pair_of_lane[pair.lane] = wishes[i].second;
  }
  first_set.push_back(lanes.sets());
}

void PairContacts::make_lanes(const Blocks& blocks, const Settings& settings,
                              const ContactsOfPairs& all,
                              const ContactsOfPairs& later) {
  constexpr int most_of_two_faces = 4;
  const auto want = [&](const ContactsOfPairs& some, bool grown) {
    for (std::size_t k = 0; k < some.pair.size(); ++k) {
      if (some.pair[k] < 0)
        continue;
      short& own = seats[some.pair[k]];
      const int count = some.first[k + 1] - some.first[k];
      // who has outgrown its seats may do so again
      const int wanted = grown && own > 0 ? std::max(count, most_of_two_faces) : count;
      own = static_cast<short>(std::max<int>(own, wanted));
    }
  };
  want(all, false);
  want(later, true);
  ContactLanes::Room room;
  each_window([&](int first, int last) {
    int sum = 0, most = 0;
    for (int p = first; p < last; ++p)
      sum += seats[p], most = std::max<int>(most, seats[p]);
    const int sets = (last - first + lane_count - 1) / lane_count;
    const int slots = sum / lane_count + most + 1;
    room.sets += sets, room.slots += slots;
  });
  room.read_sets = room.sets, room.read_slots = room.slots;
  lanes.clear();
  lanes.reserve(room, settings.rigid);
  pair_of_lane.clear();
  first_set.assign(1, 0);
  each_window([&](int first, int last) { make_sets_of_window(first, last); });
  for (int set = 0; set < lanes.sets(); ++set) {
    LanePairs& two = lanes.pairs[set];
    for (int k = 0; k < lane_count && two.low[k] != two.high[k]; ++k)
      two.damping[k] = contact_damping(settings, blocks, two.low[k], two.high[k]);
  }
  const auto put = [&](const ContactsOfPairs& some, std::size_t k) {
    int i = some.first[k];
    each_seat(some.pair[k], [&](int seat) {
      if (i < some.first[k + 1])
        set_seat(blocks, some.pair[k], seat, some.all[i++]);
    });
  };
  std::size_t of_later = 0;
  for (std::size_t k = 0; k < all.pair.size(); ++k) {
    if (all.pair[k] < 0)
      continue;
    while (of_later < later.pair.size() && later.pair[of_later] < all.pair[k])
      ++of_later;
    if (of_later == later.pair.size() || later.pair[of_later] != all.pair[k])
      put(all, k);
  }
  for (std::size_t k = 0; k < later.pair.size(); ++k)
    put(later, k);
  split.split_sets(first_set);
  lows.sort(blocks.size(), pairs, &NearPair::low);
  highs.sort(blocks.size(), pairs, &NearPair::high);
  loaded = true;
}

void PairContacts::set_seat(const Blocks& blocks, int p, int seat,
                            const PairContact& contact) {
  const bool vacant = contact.at.corner < 0;
  const int slot = seat / lane_count, k = seat % lane_count;
  SlotPlaces& places = lanes.places[slot];
  places.corner[k] = vacant ? 0 : contact.at.corner;
  places.edge[k] = vacant ? 0 : contact.at.edge;
  places.edge_end[k] = vacant ? 0 : blocks.next[contact.at.edge];
  lanes.set(seat, &SlotPlaces::flips,
            !vacant && blocks.corner_block[contact.at.edge] == pairs[p].low);
  lanes.set(seat, &SlotPlaces::asked, contact.asked);
  lanes.set(seat, &SlotPlaces::decided, contact.decided);
  lanes.set(seat, &SlotPlaces::touches, contact.touches);
  lanes.set(seat, &SlotPlaces::starts, false);
  lanes.springs[slot].normal_elastic[k] = contact.normal;
  lanes.springs[slot].shear_elastic[k] = contact.shear;
}

void PairContacts::seat(const Blocks& blocks, int p,
                        const std::vector<CornerOnEdge>& found, bool asked,
                        Share& share) {
  bool same = true, fits = true;
  std::size_t k = 0;
  share.now.clear();
  for (const CornerOnEdge& at : found)
    share.now.push_back({.at = at, .asked = asked, .decided = !asked});
  std::sort(share.now.begin(), share.now.end(),
            [](const PairContact& l, const PairContact& r) {
              return as_pair(l.at) < as_pair(r.at);
            });
  each_seat(p, [&](int seat) {
    same =
        same && (k < share.now.size() ? at(seat) == share.now[k].at : is_vacant(seat));
    ++k;
  });
  fits = share.now.size() <= k;
  if (same && fits) {
    k = 0;
    each_seat(p, [&](int seat) {
      lanes.set(seat, &SlotPlaces::asked, asked && k < share.now.size());
      lanes.set(seat, &SlotPlaces::decided, !asked && k < share.now.size());
      ++k;
    });
    return;
  }
  contacts_of(p, share.before);
  auto next = share.now.begin();
  for (const PairContact& old : share.before) {
    while (next != share.now.end() && as_pair(next->at) < as_pair(old.at))
      ++next;
    if (next != share.now.end() && next->at == old.at)
      next->touches = old.touches, next->normal = old.normal, next->shear = old.shear;
    else if (old.normal > 0.0)
      share.lost.push_back({p, old.at, old.normal, old.shear});
  }
  if (!fits) {
    share.unseated.add(p, share.now);
    return;
  }
  k = 0;
  each_seat(p, [&](int seat) {
    set_seat(blocks, p, seat, k < share.now.size() ? share.now[k] : PairContact{});
    ++k;
  });
}

bool PairContacts::join_shares() {
  unseated.clear();
  lost.clear();
  // in the order of the list, whichever thread found them
  std::vector<std::pair<int, std::pair<const ContactsOfPairs*, int>>> order;
  for (Share& share : shares) {
    lost.insert(lost.end(), share.lost.begin(), share.lost.end());
    share.lost.clear();
    for (std::size_t k = 0; k < share.unseated.pair.size(); ++k)
      order.push_back({share.unseated.pair[k], {&share.unseated, static_cast<int>(k)}});
  }
  if (order.empty())
    return false;
  std::sort(order.begin(), order.end());
  for (const auto& [p, from] : order) {
    const auto& [some, k] = from;
    unseated.add(p, {some->all.begin() + some->first[k],
                     some->all.begin() + some->first[k + 1]});
  }
  for (Share& share : shares)
    share.unseated.clear();
  return true;
}

int PairContacts::neighbours_of(int p) const {
  const auto [low, high, lane] = pairs[p];
  return first_of_block[low + 1] - first_of_block[low] + first_of_block[high + 1] -
         first_of_block[high];
}

double PairContacts::ways_of_neighbours(int p) const {
  double sum = 0.0;
  for (const int block : {pairs[p].low, pairs[p].high})
    each_neighbour(block, [&](int other) { sum += swing.way[other]; });
  return sum;
}

double PairContacts::left_of(int p) {
  DecisionLimits& limit = limits[p];
  // each of the two blocks goes as far as the travel tells
  const double left = 0.5 * (limit.way - ways_of_two(p));
  if (left > 0.0 && !(swing.travel < limit.travel)) {
    const double ways = ways_of_neighbours(p);
    const double more = limit.ways - ways - 0x1p-48 * ways;
    limit.travel = swing.travel + more / neighbours_of(p);
  }
  return std::min(left, limit.travel - swing.travel);
}

}  // namespace blocks::dynamics
