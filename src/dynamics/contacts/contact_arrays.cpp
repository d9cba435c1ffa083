#include "dynamics/contacts/contact_arrays.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <tuple>
#include <utility>

#include "dynamics/contacts/dashpot.hpp"
#include "dynamics/contacts/partners.hpp"

namespace blocks::dynamics {
namespace {

auto as_pair(const CornerOnEdge& at) { return std::pair(at.corner, at.edge); }

/// Writes the contacts in ascending order of corner and edge, without springs.
void sort_contacts(const std::vector<CornerOnEdge>& found, bool tested,
                   std::vector<PairContact>& sorted) {
  sorted.clear();
  for (const CornerOnEdge& at : found)
    sorted.push_back({{.at = at, .tested = tested, .certain = !tested}});
  std::sort(sorted.begin(), sorted.end(),
            [](const PairContact& l, const PairContact& r) {
              return as_pair(l.at) < as_pair(r.at);
            });
}

}  // namespace

void ContactArrays::contacts_of(int p, std::vector<PairContact>& contacts) const {
  contacts.clear();
  each_slot(p, [&](int slot) {
    if (is_vacant(slot))
      return;
    const bool acts = batches.is(slot, &ContactStates::acts);
    contacts.push_back({{at(slot), batches.is(slot, &ContactTests::tested),
                         batches.is(slot, &ContactTests::certain), acts,
                         acts ? batches.at(slot, &SpringRow::normal_elastic) : 0.0,
                         acts ? batches.at(slot, &SpringRow::shear_elastic) : 0.0}});
    if (acts && !laws.none())
      contacts.back().joint = joint_at(slot);
  });
}

JointState ContactArrays::joint_at(int slot) const {
  const JointRow& row = batches.joints[slot / lane_count];
  const int k = slot % lane_count, law = batches.at(slot, &FaceRow::law);
  // Contacts without a law may share a batch with others, whose kernel writes to them.
  if (law == 0 && !laws.in_situ())
    return {};
  JointState state = {.law = laws.id(law)};
  each_state([k]<class State>(State& to,
                              const double* from) { to = static_cast<State>(from[k]); },
             state, row);
  return state;
}

void ContactArrays::put_joint(int slot, const JointState& state) {
  const int k = slot % lane_count;
  each_state([k](double* to, auto from) { to[k] = static_cast<double>(from); },
             batches.joints[slot / lane_count], state);
}

/// Finds the laws of the contacts of pair p and their partners.
void ContactArrays::find_partners(const Blocks& blocks, int p) {
  const int batch = lane_of_pair[p] / lane_count;
  const int k = lane_of_pair[p] % lane_count;
  const BatchPairs& pairs = batches.pairs[batch];
  const auto row_with = [&](int corner, int edge) -> short {
    for (int i = 0; i < pairs.rows; ++i) {
      const ContactRow& row = batches.contacts[pairs.first_row + i];
      if (row.corner[k] == corner && row.edge[k] == edge)
        return static_cast<short>(i);
    }
    return -1;
  };
  each_slot(p, [&](int slot) {
    FaceRow& face = batches.faces[slot / lane_count];
    const auto [corner, edge] = at(slot);
    const bool vacant = is_vacant(slot);
    const int before = vacant ? 0 : blocks.previous[corner];
    face.law[k] = vacant ? 0 : laws.law_of(blocks, corner, edge);
    face.before[k] = before;
    face.after[k] = vacant ? 0 : blocks.next[corner];
    face.partner_before[k] = vacant ? short{-1} : row_with(edge, before);
    face.partner_after[k] = vacant ? short{-1} : row_with(blocks.next[edge], corner);
    if (!vacant)
      batches.include_law(batch, face.law[k], laws.bit(face.law[k]));
  });
  batches.find_shared_ends(batch, k);
}

void ContactArrays::renumber_corners(const std::vector<int>& new_of) {
  for (int slot = 0; slot < lane_count * batches.rows(); ++slot)
    if (!is_vacant(slot))
      for (const auto which : {&ContactRow::corner, &ContactRow::edge})
        batches.at(slot, which) =
            new_of[static_cast<std::size_t>(batches.at(slot, which))];
}

void ContactArrays::copy_contacts(ContactsOfPairs& all) const {
  all.clear();
  std::vector<PairContact> own;
  for (int p = 0; p < static_cast<int>(lane_of_pair.size()); ++p)
    if (contacts_of(p, own); !own.empty())
      all.add(p, own, !laws.none());
}

void ContactArrays::require_slots(const ContactsOfPairs& some, bool grown) {
  for (std::size_t k = 0; k < some.pair.size(); ++k) {
    if (some.pair[k] < 0)
      continue;
    int& slots = slots_of_pair[some.pair[k]];
    const int count = some.first[k + 1] - some.first[k];
    // A pair that has outgrown its slots is likely to need still more.
    const int wanted =
        grown && slots > 0 ? std::max(count, contacts_of_two_faces) : count;
    slots = std::max(slots, wanted);
  }
}

void ContactArrays::reserve(int pairs) {
  int all_batches = 0, all_rows = 0;
  each_window(pairs, [&](int begin, int end) {
    int sum = 0, most = 0;
    for (int p = begin; p < end; ++p)
      sum += slots_of_pair[p], most = std::max(most, slots_of_pair[p]);
    all_batches += (end - begin + lane_count - 1) / lane_count;
    // Pairs with laws and pairs without are each in descending order of their slots. So
    // a batch has at most as many rows as the mean of the batch before, except the
    // first batch, one with pairs of both kinds, and the one after it.
    all_rows += sum / lane_count + (laws.none() ? 1 : 3) * most + 1;
  });
  batches.reserve(all_batches, all_rows, !laws.none());
}

/// Puts the pairs of a window into batches in descending order of their slots, so that
/// few slots stay vacant. Pairs with laws of joints come first, so that few batches
/// have pairs of both kinds.
void ContactArrays::make_window(const Blocks& blocks, const PairIndex& index, int begin,
                                int end) {
  struct Place {
    bool without_laws;
    int slots, pair;
    auto operator<=>(const Place& other) const {
      return std::tuple(without_laws, -slots, pair) <=>
             std::tuple(other.without_laws, -other.slots, other.pair);
    }
  };
  std::array<Place, pairs_of_window> order;
  int count = 0;
  for (int p = begin; p < end; ++p) {
    lane_of_pair[p] = -1;
    if (slots_of_pair[p] > 0)
      order[count++] = {!laws.may_act(blocks, index.pairs[p].low, index.pairs[p].high),
                        slots_of_pair[p], p};
  }
  std::sort(order.begin(), order.begin() + count);
  for (int i = 0; i < count; ++i) {
    const int k = i % lane_count, p = order[i].pair;
    if (k == 0) {
      int rows = 0;
      for (int j = i; j < std::min(count, i + lane_count); ++j)
        rows = std::max(rows, order[j].slots);
      batches.add_batch(rows);
    }
    const int batch = batches.batches() - 1;
    if (!order[i].without_laws)
      batches.expect_laws(batch);
    batches.pairs[batch].low[k] = index.pairs[p].low;
    batches.pairs[batch].high[k] = index.pairs[p].high;
    lane_of_pair[p] = batch * lane_count + k;
    pair_of_lane.resize(static_cast<std::size_t>(batch + 1) * lane_count, -1);
    pair_of_lane[lane_of_pair[p]] = p;
  }
  first_batch.push_back(batches.batches());
}

void ContactArrays::make(const Blocks& blocks, const Settings& settings,
                         const PairIndex& index, const ContactsOfPairs& kept,
                         const ContactsOfPairs& grown) {
  const int pairs = index.size();
  laws.make(settings, blocks);
  batches.laws = laws.columns();
  lane_of_pair.resize(static_cast<std::size_t>(pairs));
  require_slots(kept, false);
  require_slots(grown, true);
  batches.clear();
  reserve(pairs);
  pair_of_lane.clear();
  first_batch.assign(1, 0);
  each_window(pairs,
              [&](int begin, int end) { make_window(blocks, index, begin, end); });
  for (int batch = 0; batch < batches.batches(); ++batch) {
    BatchPairs& two = batches.pairs[batch];
    for (int k = 0; k < lane_count && two.low[k] != two.high[k]; ++k)
      two.damping[k] = contact_damping(settings, blocks, two.low[k], two.high[k]);
  }
  // A pair that has outgrown its slots has more contacts than before, so the second
  // list replaces all of the first one.
  for (const ContactsOfPairs* some : {&kept, &grown})
    for (std::size_t k = 0; k < some->pair.size(); ++k)
      if (some->pair[k] >= 0)
        fill_slots(blocks, index, *some, k);
  find_lanes_of_blocks(index, &NearPair::low, lows);
  find_lanes_of_blocks(index, &NearPair::high, highs);
}

void ContactArrays::find_lanes_of_blocks(const PairIndex& index, int NearPair::*side,
                                         Groups& lanes) {
  lanes.sort(index.neighbours.groups(), [&](const auto& add) {
    for (int p = 0; p < index.size(); ++p)
      if (lane_of_pair[p] >= 0)
        add(index.pairs[p].*side, lane_of_pair[p]);
  });
}

void ContactArrays::fill_slots(const Blocks& blocks, const PairIndex& index,
                               const ContactsOfPairs& some, std::size_t k) {
  const int p = some.pair[k];
  int i = some.first[k];
  each_slot(p, [&](int slot) {
    if (i < some.first[k + 1])
      fill_slot(blocks, index.pairs[p].low, slot,
                some.at(static_cast<std::size_t>(i++)));
  });
  if (has_laws(p))
    find_partners(blocks, p);
}

void ContactArrays::fill_slot(const Blocks& blocks, int low, int slot,
                              const PairContact& contact) {
  const bool vacant = contact.at.corner < 0;
  const int row = slot / lane_count, k = slot % lane_count;
  ContactRow& to = batches.contacts[row];
  to.corner[k] = vacant ? 0 : contact.at.corner;
  to.edge[k] = vacant ? 0 : contact.at.edge;
  to.edge_end[k] = vacant ? 0 : blocks.next[contact.at.edge];
  batches.set(slot, &ContactTests::edge_is_low,
              !vacant && blocks.corner_block[contact.at.edge] == low);
  batches.set(slot, &ContactTests::tested, contact.tested);
  batches.set(slot, &ContactTests::certain, contact.certain);
  batches.set(slot, &ContactStates::acts, contact.acted);
  batches.set(slot, &ContactStates::starts, false);
  batches.springs[row].normal_elastic[k] = contact.normal;
  batches.springs[row].shear_elastic[k] = contact.shear;
  if (!laws.none())
    put_joint(slot, contact.joint);
}

/// Adds the contacts of `before` that may be held to `now`, in order. Leaves out
/// contacts whose corner is bonded to another edge of the block.
void ContactArrays::keep_held(std::vector<PairContact>& now,
                              const std::vector<PairContact>& before) const {
  std::erase_if(now, [&](const PairContact& found) {
    return std::any_of(before.begin(), before.end(), [&](const PairContact& old) {
      return old.acted && old.joint.bonded && old.at.corner == found.at.corner &&
             old.at.edge != found.at.edge;
    });
  });
  for (const PairContact& old : before) {
    if (!old.may_be_held())
      continue;
    const auto place = std::lower_bound(now.begin(), now.end(), old,
                                        [](const PairContact& l, const PairContact& r) {
                                          return as_pair(l.at) < as_pair(r.at);
                                        });
    if (place == now.end() || place->at != old.at)
      now.insert(place, PairContact{{.at = old.at}});
  }
}

void ContactArrays::assign(const Blocks& blocks, const PairIndex& index, int p,
                           const std::vector<CornerOnEdge>& found, bool tested,
                           ContactChanges& changes) {
  std::vector<PairContact>& now = changes.now;
  sort_contacts(found, tested, now);
  const std::vector<PairContact>& before = changes.before;
  const bool may_hold = has_laws(p);
  if (may_hold) {
    contacts_of(p, changes.before);
    keep_held(now, before);
    if (laws.in_situ())
      add_partners(blocks, now);
  }
  bool same = true;
  std::size_t slots = 0;
  each_slot(p, [&](int slot) {
    same = same && (slots < now.size() ? at(slot) == now[slots].at : is_vacant(slot));
    ++slots;
  });
  const bool fits = now.size() <= slots;
  std::size_t k = 0;
  if (same && fits) {
    each_slot(p, [&](int slot) {
      batches.set(slot, &ContactTests::tested, k < now.size() && now[k].tested);
      batches.set(slot, &ContactTests::certain, k < now.size() && now[k].certain);
      ++k;
    });
    return;
  }
  if (!may_hold)
    contacts_of(p, changes.before);
  auto next = now.begin();
  for (const PairContact& old : before) {
    while (next != now.end() && as_pair(next->at) < as_pair(old.at))
      ++next;
    if (next != now.end() && next->at == old.at)
      next->acted = old.acted, next->normal = old.normal, next->shear = old.shear,
      next->joint = old.joint;
    else if (old.normal > 0.0)
      changes.released.push_back({p, old.at, old.normal, old.shear, old.joint});
  }
  if (!fits) {
    changes.grown.add(p, now, !laws.none());
    return;
  }
  each_slot(p, [&](int slot) {
    fill_slot(blocks, index.pairs[p].low, slot,
              k < now.size() ? now[k] : PairContact{});
    ++k;
  });
  if (has_laws(p))
    find_partners(blocks, p);
}

}  // namespace blocks::dynamics
