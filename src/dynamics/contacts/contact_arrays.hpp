// The contacts of all pairs in batches of SIMD lanes, and the mapping between pairs and
// lanes. The arrangement has no influence on results.
#pragma once

#include <vector>

#include "dynamics/contacts/contact_batches.hpp"
#include "dynamics/contacts/law_table.hpp"
#include "dynamics/contacts/pair_contacts.hpp"
#include "dynamics/search/pair_index.hpp"
#include "dynamics/support/groups.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// The number of pairs in a window. One thread decides all pairs of a window, and no
/// batch has pairs of two windows.
inline constexpr int pairs_of_window = 256;

struct ContactArrays {
  /// Both ends of each of two faces may act on the other one.
  static constexpr int contacts_of_two_faces = 4;

  ContactBatches batches;
  LawTable laws;
  std::vector<int> lane_of_pair;   ///< -1: the pair has no slots
  std::vector<int> pair_of_lane;   ///< -1: the lane is idle
  std::vector<int> slots_of_pair;  ///< slots that the pair needs; its lane has them
  std::vector<int> first_batch;    ///< (windows + 1) the first batch of each window
  /// lanes in which each block is the lower one, or the higher one
  Groups lows, highs;

  /// Makes batches for the pairs of the index that need slots, and puts
  /// the contacts into them. `kept` are the contacts until now, `grown` those of pairs
  /// that need more slots than before, in any order. A pair that is in both gets the
  /// contacts of `grown`, which must then be more. No pair may be listed twice in
  /// either of them. Entries with a negative pair are ignored.
  void make(const Blocks& blocks, const Settings& settings, const PairIndex& index,
            const ContactsOfPairs& kept, const ContactsOfPairs& grown);
  /// Assigns these contacts to pair p. If `tested`, a contact acts only if its corner
  /// is inside its edge and between the ends. Otherwise all of them act. Contacts that
  /// the pair had before keep their springs. Held contacts (PairContact::may_be_held)
  /// are kept too, and a corner that is bonded to a block acts only where it is bonded.
  /// After INSITU the contacts at the same ends of faces get slots too.
  /// Loaded springs of its other former contacts are added to changes.released. If the
  /// pair has too few slots, its contacts are added to changes.grown instead of the
  /// slots.
  void assign(const Blocks& blocks, const PairIndex& index, int p,
              const std::vector<CornerOnEdge>& found, bool tested,
              ContactChanges& changes);
  /// Gives corners new numbers. The contacts of other corners are then not usable.
  /// new_of: (old corners) -1: the corner has no new number.
  void renumber_corners(const std::vector<int>& new_of);
  /// Copies the contacts of all pairs.
  void copy_contacts(ContactsOfPairs& all) const;

  /// Calls visit(slot) for each slot of a pair, in ascending order.
  template <class Visit> void each_slot(int p, const Visit& visit) const {
    if (lane_of_pair[p] < 0)
      return;
    const BatchPairs& batch = batches.pairs[lane_of_pair[p] / lane_count];
    for (int row = batch.first_row; row < batch.first_row + batch.rows; ++row)
      visit(row * lane_count + lane_of_pair[p] % lane_count);
  }
  /// Calls visit(lane, is_low) for each lane that contains a pair of block b, in the
  /// order of the pairs. is_low: block b is the lower one.
  template <class Visit> void each_lane_of(int b, const Visit& visit) const {
    highs.each(b, [&](int lane) { visit(static_cast<unsigned>(lane), false); });
    lows.each(b, [&](int lane) { visit(static_cast<unsigned>(lane), true); });
  }
  CornerOnEdge at(int slot) const {
    return {batches.at(slot, &ContactRow::corner), batches.at(slot, &ContactRow::edge)};
  }
  /// Returns the state of the law of a slot.
  LawState law_state_at(int slot) const;
  /// Sets the state of the law of a slot.
  void put_law_state(int slot, const LawState& state);
  /// Returns whether the slot has no contact. Such a slot has equal corner and edge,
  /// which no contact has.
  bool is_vacant(int slot) const { return at(slot).corner == at(slot).edge; }

 private:
  void contacts_of(int p, std::vector<PairContact>& contacts) const;
  void find_partners(const Blocks& blocks, int p);
  void fill_slot(const Blocks& blocks, int low, int slot, const PairContact& contact);
  void fill_slots(const Blocks& blocks, const PairIndex& index,
                  const ContactsOfPairs& some, std::size_t k);
  void require_slots(const ContactsOfPairs& some, bool grown);
  void arrange_pairs(const Blocks& blocks, const PairIndex& index);
  void make_batches(const Blocks& blocks, const Settings& settings,
                    const PairIndex& index);
  /// Calls visit(lane of the batch, pair) for each pair of a batch.
  template <class Visit> void each_pair_of(int batch, const Visit& visit) const {
    for (int k = 0; k < lane_count; ++k)
      if (const int p = pair_of_lane[batch * lane_count + k]; p >= 0)
        visit(k, p);
  }
  bool has_laws(int p) const {
    return lane_of_pair[p] >= 0 && batches.pairs[lane_of_pair[p] / lane_count].has_laws;
  }
  void find_lanes_of_blocks(const PairIndex& index, int NearPair::*side, Groups& lanes);
};

/// Returns the columns of blocks from which contacts are computed.
inline BlockState state_of(const Blocks& blocks) {
  return {blocks.corner.data(), blocks.centroid.data(), blocks.velocity.data(),
          blocks.spin.data(), blocks.strain_rate.data()};
}

}  // namespace blocks::dynamics
