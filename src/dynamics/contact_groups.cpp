#include "dynamics/contact_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "dynamics/dashpot.hpp"

namespace blocks::dynamics {
namespace {

/// How often two neighbours of 0 .. count - 1 differ, and one more.
template <class Differ> std::size_t stretches(int count, const Differ& differ) {
  std::size_t found = count > 0;
  for (int i = 1; i < count; ++i)
    found += differ(i - 1, i);
  return found;
}

void find_pairs(const Blocks& blocks, const Contacts& contacts, ContactGroups& groups) {
  const int count = static_cast<int>(groups.all.size());
  const auto pair = [&](int g) {
    return pair_of(blocks, contacts, groups.all[g].first);
  };
  groups.pairs.clear();
  groups.pairs.reserve(
      stretches(count, [&](int g, int h) { return pair(g) != pair(h); }));
  for (int g = 0; g < count; ++g) {
    const auto [low, high] = pair(g);
    if (groups.pairs.empty() || groups.pairs.back().low != low ||
        groups.pairs.back().high != high)
      groups.pairs.push_back({.low = low, .high = high, .first = g, .last = g});
    groups.pairs.back().last = g + 1;
  }
}

/// each_alone: one record to a group.
void find_groups(const Blocks& blocks, const Contacts& contacts, bool each_alone,
                 ContactGroups& groups) {
  const int size = contacts.size();
  const auto edge_block = [&](int i) { return blocks.corner_block[contacts.edge[i]]; };
  const auto other_group = [&](int i, int j) {
    return each_alone || contacts.corner[i] != contacts.corner[j] ||
           edge_block(i) != edge_block(j);
  };
  const auto notched = [&](int i) {
    return !each_alone && !blocks.convex[edge_block(i)];
  };
  groups.all.clear();
  std::size_t count = stretches(size, other_group);
  for (int i = 0; i < size; ++i)
    count += notched(i) && (i == 0 || other_group(i - 1, i));
  groups.all.reserve(count);
  for (int first = 0, last; first < size; first = last) {
    last = first + 1;
    while (last < size && !other_group(first, last) &&
           last - first < static_cast<int>(ContactGroup::most_records))
      ++last;
    ContactGroup group;
    group.first = first;
    group.count = static_cast<std::uint32_t>(last - first) & ContactGroup::most_records;
    group.edge_block = edge_block(first);
    group.reentrant = notched(first);
    groups.all.push_back(group);
    if (group.reentrant) {
      group.reentrant = 0, group.of_notch = 1;
      groups.all.push_back(group);
    }
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

namespace {

/// To 7 bits.
double rounded_up(double length) {
  int exponent = 0;
  const double mantissa = std::frexp(length, &exponent);
  return std::ldexp(std::ceil(std::ldexp(mantissa, 7)), exponent - 7);
}

}  // namespace

void ContactGroup::set(const Certainty& known) {
  record = known.candidate;
  travel = unasked = rounded_down(known.travel);
  place = static_cast<std::int8_t>(known.place);
  asks = known.asks;
}

void Swing::start(const Blocks& blocks, bool rigid_blocks) {
  rigid = rigid_blocks;
  for (std::vector<double>* column : {&longest, &sum, &way})
    column->assign(blocks.size(), 0.0);
  shape.resize(4, rigid ? 0 : blocks.size());
  shape.colwise() = Eigen::Vector4d(1.0, 0.0, 0.0, 1.0);
  reach.setZero(2, shape.cols());
  travel = 0.0;
  // no chord is longer than its arc; a little more for the roots
  for (int c = 0; c < blocks.corners(); ++c) {
    double& most = longest[blocks.corner_block[c]];
    most = std::max(most, 1.0001 * blocks.arm.col(c).norm());
    if (!rigid) {
      auto most_of_each = reach.col(blocks.corner_block[c]);
      most_of_each = most_of_each.cwiseMax(1.0001 * blocks.arm.col(c).cwiseAbs());
    }
  }
  // The same whenever groups are made, so that a run and its restart count the same
  // travel, though arms that turn change by round-off.
  std::transform(longest.begin(), longest.end(), longest.begin(), rounded_up);
}

double Swing::reshaped(int b, const Eigen::Vector4d& since) const {
  const Eigen::Array4d change = (shape.col(b) - since).cwiseAbs();
  const double along_x = change[0] * reach(0, b) + change[2] * reach(1, b);
  const double along_y = change[1] * reach(0, b) + change[3] * reach(1, b);
  return std::sqrt(along_x * along_x + along_y * along_y);
}

namespace {

/// How it is known whether the group's contact acts.
signed char rule_of(const ContactGroup& group) {
  return group.record < 0 ? idle : group.certain() ? by_sign : decided;
}

/// Whether the list says that a record of the group acts.
bool acted(const Contacts& contacts, const ContactGroup& group) {
  return std::any_of(contacts.active.begin() + group.first,
                     contacts.active.begin() + group.last(), [](char a) { return a; });
}

}  // namespace

void LanesOfBlocks::sort(int blocks, const std::vector<ContactPair>& pairs,
                         int ContactPair::*side) {
  first.assign(blocks + 1, 0);
  for (const ContactPair& pair : pairs)
    first[pair.*side + 1] += pair.lane >= 0;
  std::partial_sum(first.begin(), first.end(), first.begin());
  lane.resize(first.back());
  for (const ContactPair& pair : pairs)
    if (pair.lane >= 0)
      lane[first[pair.*side]++] = pair.lane;
  // each was moved on to where the next begins
  std::move_backward(first.begin(), first.end() - 1, first.end());
  first[0] = 0;
}

bool ContactGroups::keep_seat(int g) {
  const int seat = seat_of[g];
  if (seat < 0 || record[seat] != all[g].record)
    return false;
  lanes.at(seat, &SlotPlaces::rule) = rule_of(all[g]);
  return true;
}

bool ContactGroups::set_seat(const Blocks& blocks, const Contacts& contacts, int g,
                             int i, const HeldSpring& spring) {
  const ContactGroup& known = all[g];
  const int seat = seat_of[g];
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
  places.flip[k] =
      known.edge_block < blocks.corner_block[contacts.corner[known.first]] ? 1 : 0;
  places.rule[k] = rule_of(known);
  places.touch[k] = spring.record >= 0 ? in_touch : apart;
  springs.normal_elastic[k] = spring.normal;
  springs.shear_elastic[k] = spring.shear;
  return true;
}

HeldSpring ContactGroups::held(int seat) const {
  if (record[seat] < 0 || lanes.at(seat, &SlotPlaces::touch) == apart)
    return {};
  return {record[seat], lanes.at(seat, &SlotSprings::normal_elastic),
          lanes.at(seat, &SlotSprings::shear_elastic)};
}

void ContactGroups::take_pose(const Blocks& blocks, int pair) {
  const int low = pairs[pair].low, high = pairs[pair].high;
  poses[pair] = {blocks.centroid(0, low) - blocks.centroid(0, high),
                 blocks.centroid(1, low) - blocks.centroid(1, high), blocks.angle[low],
                 blocks.angle[high], swing.sum[low] + swing.sum[high]};
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
  constexpr std::size_t many = 1 << 16;
  if (all.size() > many)
    *this = {};
}

void ContactGroups::forget_decisions() {
  for (ContactPair& pair : pairs)
    pair.certain = 0.0, pair.prompt = 0;
  std::fill(prompt.begin(), prompt.end(), std::uint8_t{0});
  std::fill(limits.begin(), limits.end(), 0.0);
  std::fill(rounds.begin(), rounds.end(), 0.0);
  for (ContactGroup& each : all)
    each.travel = 0.0F, each.hopeless = 1;
}

void ContactGroups::load(const Blocks& blocks, const Contacts& contacts,
                         const Settings& settings) {
  for (int set = 0; set < lanes.sets(); ++set) {
    LanePairs& two = lanes.pairs[set];
    for (int k = 0; k < lane_count && two.low[k] != two.high[k]; ++k)
      two.damping[k] = contact_damping(settings, blocks, two.low[k], two.high[k]);
  }
  const int count = static_cast<int>(all.size());
  for (int g = 0; g < count; ++g)
    if (seat_of[g] >= 0)
      set_seat(blocks, contacts, g, all[g].record, {});
  int g = 0;
  for (const ActingContact& contact : contacts.acting) {
    const int i = contact.record;
    while (all[g].last() <= i)
      ++g;
    // a notch has two seats; nothing is decided yet in those of a new list
    const auto wanted = [&](int number) {
      for (int of = g; of <= g + static_cast<int>(all[g].reentrant); ++of)
        if (record[seat_of[of]] == number)
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
  loaded = true;
  read = false;
}

void ContactGroups::begin_store(Contacts& contacts) {
  for (const ActingContact& before : contacts.acting)
    contacts.active[before.record] = 0;
  contacts.acting.clear();
}

void ContactGroups::store(Contacts& contacts, int g, bool with_readings) const {
  const int seat = seat_of[g], slot = seat / lane_count, k = seat % lane_count;
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
  contacts.active[contact.record] = 1;
  // the two seats of a notch hold records of the same range
  if (auto last = contacts.acting.end() - 1;
      last != contacts.acting.begin() && last->record < (last - 1)->record)
    std::iter_swap(last, last - 1);
}

void ContactGroups::store(Contacts& contacts) {
  if (loaded && !read) {
    begin_store(contacts);
    const int count = static_cast<int>(all.size());
    for (int g = 0; g < count; ++g)
      if (seat_of[g] >= 0 && held(seat_of[g]).record >= 0)
        store(contacts, g, false);
  }
  loaded = false;
}

int ContactGroups::group_of(int seat) const {
  const auto after = std::upper_bound(
      all.begin(), all.end(), record[seat],
      [](int i, const ContactGroup& group) { return i < group.first; });
  const int g = static_cast<int>(after - all.begin()) - 1;
  return seat_of[g] == seat ? g : g - 1;  // a notch has two
}

void ContactGroups::join_shares() {
  for (Share& share : shares) {
    lost.insert(lost.end(), share.lost.begin(), share.lost.end());
    seats_complete = seats_complete && share.seats_complete;
    share.lost.clear();
    share.seats_complete = true;
  }
}

void ContactGroups::make_lanes(int blocks, const Contacts& contacts) {
  // not at first, for most of those who are near in a wall at rest never act
  const double soon = times_made > 1 ? 2.0 * (swing.travel - made_at) : 0.0;
  ++times_made;
  made_at = swing.travel;
  const auto may_act_soon = [&](const ContactPair& pair, int g) {
    if ((pair.prompt & pair.bit(g)) != 0)
      return soon > 0.0;
    const ContactGroup& one = all[g];
    return one.certain() ? one.lasts() < soon : soon > 0.0 && one.hopeless > 0;
  };
  for (const ContactPair& pair : pairs)
    for (int g = pair.first; g < pair.last; ++g) {
      // who had a seat keeps it: it may want it again
      const bool wants = seat_of[g] >= 0 || all[g].record >= 0 ||
                         acted(contacts, all[g]) || may_act_soon(pair, g);
      seat_of[g] = wants ? 0 : -1;
      // of a notch both or none: a spring may pass from one to the other
      if (all[g].of_notch && seat_of[g] != seat_of[g - 1])
        seat_of[g] = seat_of[g - 1] = 0;
    }
  lanes.clear();
  const int count = static_cast<int>(pairs.size());
  for (int first = 0; first < count; first += pairs_of_window)
    seat_window(first, std::min(count, first + pairs_of_window));
  lows.sort(blocks, pairs, &ContactPair::low);
  highs.sort(blocks, pairs, &ContactPair::high);
  seats_complete = true;
}

void ContactGroups::seat_window(int first, int last) {
  struct Wish {
    int contacts, pair;
  };
  std::array<Wish, pairs_of_window> wishes;
  int count = 0;
  for (int p = first; p < last; ++p) {
    const auto begin = seat_of.begin() + pairs[p].first;
    const auto wants = std::count(begin, seat_of.begin() + pairs[p].last, 0);
    pairs[p].lane = -1;
    if (wants > 0)
      wishes[count++] = {static_cast<int>(wants), p};
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
    for (int g = pair.first; g < pair.last; ++g)
      if (seat_of[g] >= 0)
        seat_of[g] = std::exchange(seat, seat + lane_count);
  }
}

namespace {

/// Memory for the case that all groups act.
void reserve_lanes(ContactGroups& groups, bool rigid) {
  ContactLanes::Room room;
  const int count = static_cast<int>(groups.pairs.size());
  for (int first = 0; first < count; first += pairs_of_window) {
    const int last = std::min(count, first + pairs_of_window);
    int sum = 0, most = 0;
    for (int p = first; p < last; ++p) {
      const int own = groups.pairs[p].last - groups.pairs[p].first;
      sum += own, most = std::max(most, own);
    }
    // by size: no set but the first has more slots than each pair of that before
    const int sets = (last - first + lane_count - 1) / lane_count;
    const int slots = sum / lane_count + most;
    room.sets += sets, room.slots += slots;
    room.read_sets = std::max(room.read_sets, sets);
    room.read_slots = std::max(room.read_slots, slots);
  }
  groups.lanes.reserve(room, rigid);
  groups.record.reserve(static_cast<std::size_t>(room.slots) * lane_count);
  for (LanesOfBlocks* of : {&groups.lows, &groups.highs})
    of->lane.reserve(groups.pairs.size());
}

}  // namespace

void group_contacts(const Blocks& blocks, const Contacts& contacts, bool rigid,
                    ContactGroups& groups, bool each_alone, int threads) {
  find_groups(blocks, contacts, each_alone, groups);
  find_pairs(blocks, contacts, groups);
  sort_by_corner(blocks, contacts, groups);
  groups.seat_of.assign(groups.all.size(), -1);
  groups.limits.assign(groups.pairs.size(), 0.0);
  groups.rounds.assign((groups.pairs.size() + pairs_of_round - 1) / pairs_of_round,
                       0.0);
  groups.prompt.assign(groups.rounds.size(), 0);
  reserve_lanes(groups, rigid);
  groups.times_made = 0;
  groups.loaded = groups.read = false;
  groups.lost.clear();
  groups.lost.reserve(groups.all.size());
  groups.heirs.reserve(groups.all.size());
  groups.shares.resize(threads);
  for (ContactGroups::Share& share : groups.shares) {
    share.lost.clear();
    share.lost.reserve(groups.all.size() / threads + 64);
  }
  groups.swing.start(blocks, rigid);
  groups.poses.assign(groups.pairs.size(), {});
  groups.shapes.assign(rigid ? 0 : groups.pairs.size(), {});
  groups.make_lanes(blocks.size(), contacts);
}

}  // namespace blocks::dynamics
