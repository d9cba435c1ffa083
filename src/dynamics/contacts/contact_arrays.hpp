// The contacts of all pairs in batches of SIMD lanes, and which pair has which lane.
// The arrangement has no influence on results.
#pragma once

#include <algorithm>
#include <vector>

#include "dynamics/contacts/contact_batches.hpp"
#include "dynamics/contacts/pair_contacts.hpp"
#include "dynamics/search/pair_index.hpp"
#include "dynamics/support/groups.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Pairs of a window. One thread decides them all, and they have their own batches.
inline constexpr int pairs_of_window = 256;

struct ContactArrays {
  ContactBatches batches;
  std::vector<int> lane_of_pair;   ///< -1: the pair has had no contacts
  std::vector<int> pair_of_lane;   ///< -1: the lane is idle
  std::vector<int> slots_of_pair;  ///< least number of slots of the pair's lane
  std::vector<int> first_batch;    ///< (windows + 1) where those of a window begin
  Groups lows, highs;  ///< lanes in which each block is the low one, or the high one

  /// Makes batches for these pairs and puts contacts into them. `grown` replaces all
  /// contacts of its pairs. No pair is listed twice; entries with a negative pair are
  /// ignored.
  void make(const Blocks& blocks, const Settings& settings, const PairIndex& index,
            const ContactsOfPairs& kept, const ContactsOfPairs& grown);
  /// Gives pair p these contacts. If `tested`, those of them act that are inside and
  /// between; otherwise all act. Contacts that it had before keep their springs; the
  /// springs of others are released.
  void assign(const Blocks& blocks, const PairIndex& index, int p,
              const std::vector<CornerOnEdge>& found, bool tested,
              ContactChanges& changes);
  /// Copies the contacts of all pairs.
  void take_out(ContactsOfPairs& all) const;

  /// Calls visit(slot) for each slot of a pair, in ascending order.
  template <class Visit> void each_slot(int p, const Visit& visit) const {
    if (lane_of_pair[p] < 0)
      return;
    const BatchPairs& batch = batches.pairs[lane_of_pair[p] / lane_count];
    for (int row = batch.first_row; row < batch.first_row + batch.rows; ++row)
      visit(row * lane_count + lane_of_pair[p] % lane_count);
  }
  /// Calls visit(lane, is_low) for each lane that acts on block b, in the order of the
  /// pairs.
  template <class Visit> void each_lane_of(int b, const Visit& visit) const {
    highs.each(b, [&](int lane) { visit(static_cast<unsigned>(lane), false); });
    lows.each(b, [&](int lane) { visit(static_cast<unsigned>(lane), true); });
  }
  CornerOnEdge at(int slot) const {
    return {batches.at(slot, &ContactRow::corner), batches.at(slot, &ContactRow::edge)};
  }
  /// The slot has no contact: a corner never acts on its own edge.
  bool is_vacant(int slot) const { return at(slot).corner == at(slot).edge; }

 private:
  void contacts_of(int p, std::vector<PairContact>& contacts) const;
  void fill_slot(const Blocks& blocks, int low, int slot, const PairContact& contact);
  void fill_slots(const Blocks& blocks, const PairIndex& index,
                  const ContactsOfPairs& some, std::size_t k);
  void require_slots(const ContactsOfPairs& some, bool grown);
  void reserve(int pairs);
  void make_window(const PairIndex& index, int begin, int end);
  void find_lanes_of_blocks(const PairIndex& index, int NearPair::*side, Groups& lanes);
};

/// Calls visit(begin, end) for pairs begin .. end - 1 of each window.
template <class Visit> void each_window(int pairs, const Visit& visit) {
  for (int begin = 0; begin < pairs; begin += pairs_of_window)
    visit(begin, std::min(pairs, begin + pairs_of_window));
}

/// The columns of blocks that contacts are computed from.
inline BlockState state_of(const Blocks& blocks) {
  return {blocks.corner.data(), blocks.centroid.data(), blocks.velocity.data(),
          blocks.spin.data(), blocks.strain_rate.data()};
}

}  // namespace blocks::dynamics
