#include "dynamics/contacts/contact_arrays.hpp"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <tuple>

#include "dynamics/contacts/dashpot.hpp"

namespace blocks::dynamics {
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
      contacts.back().law_state = law_state_at(slot);
  });
}

LawState ContactArrays::law_state_at(int slot) const {
  const LawRow& row = batches.law_states[slot / lane_count];
  const int k = slot % lane_count, law = batches.at(slot, &FaceRow::law);
  // Contacts without a law may share a batch with others, whose kernel writes to them.
  if (law == 0 && !laws.in_situ())
    return {};
  LawState state = {.law = laws.id(law)};
  each_state([k]<class State>(State& to,
                              const double* from) { to = static_cast<State>(from[k]); },
             state, row);
  return state;
}

void ContactArrays::put_law_state(int slot, const LawState& state) {
  const int k = slot % lane_count;
  each_state([k](double* to, auto from) { to[k] = static_cast<double>(from); },
             batches.law_states[slot / lane_count], state);
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

/// Puts the pairs of each window into batches in descending order of their slots, so
/// that few slots stay vacant. Pairs with laws of joints come first, so that few
/// batches have pairs of both kinds.
void ContactArrays::arrange_pairs(const Blocks& blocks, const PairIndex& index) {
  struct Place {
    bool without_laws;
    int slots, pair;
    auto operator<=>(const Place& other) const {
      return std::tuple(without_laws, -slots, pair) <=>
             std::tuple(other.without_laws, -other.slots, other.pair);
    }
  };
  std::vector<Place> order;
  lane_of_pair.assign(static_cast<std::size_t>(index.size()), -1);
  pair_of_lane.clear();
  first_batch.assign(1, 0);
  for (int begin = 0; begin < index.size(); begin += pairs_of_window) {
    const int end = std::min(index.size(), begin + pairs_of_window);
    order.clear();
    for (int p = begin; p < end; ++p)
      if (slots_of_pair[p] > 0)
        order.push_back({!laws.may_act(blocks, index.pairs[p].low, index.pairs[p].high),
                         slots_of_pair[p], p});
    std::sort(order.begin(), order.end());
    for (const Place& place : order) {
      lane_of_pair[place.pair] = static_cast<int>(pair_of_lane.size());
      pair_of_lane.push_back(place.pair);
    }
    while (pair_of_lane.size() % lane_count != 0)
      pair_of_lane.push_back(-1);
    first_batch.push_back(static_cast<int>(pair_of_lane.size()) / lane_count);
  }
}

/// Makes the batches of the lanes, with vacant slots.
void ContactArrays::make_batches(const Blocks& blocks, const Settings& settings,
                                 const PairIndex& index) {
  const auto rows_of = [&](int batch) {
    int rows = 0;
    each_pair_of(batch, [&](int, int p) { rows = std::max(rows, slots_of_pair[p]); });
    return rows;
  };
  const int count = first_batch.back();
  int rows = 0;
  for (int batch = 0; batch < count; ++batch)
    rows += rows_of(batch);
  batches.reserve(count, rows, !laws.none());
  for (int batch = 0; batch < count; ++batch) {
    batches.add_batch(rows_of(batch));
    BatchPairs& pairs = batches.pairs[batch];
    each_pair_of(batch, [&](int k, int p) {
      const auto [low, high] = index.pairs[p];
      pairs.low[k] = low, pairs.high[k] = high;
      pairs.damping[k] = contact_damping(settings, blocks, low, high);
      pairs.has_laws = pairs.has_laws || laws.may_act(blocks, low, high);
    });
  }
}

void ContactArrays::make(const Blocks& blocks, const Settings& settings,
                         const PairIndex& index, const ContactsOfPairs& kept,
                         const ContactsOfPairs& grown) {
  laws.make(settings, blocks);
  batches.laws = laws.columns();
  require_slots(kept, false);
  require_slots(grown, true);
  arrange_pairs(blocks, index);
  make_batches(blocks, settings, index);
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
    put_law_state(slot, contact.law_state);
}

}  // namespace blocks::dynamics
