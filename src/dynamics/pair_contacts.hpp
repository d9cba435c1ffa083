// Pairs of blocks that are near each other, what was decided of them and for how long
// that holds, and their contacts, which stand in lanes (contact_lanes.hpp). Working
// state: not part of the model, and without influence on results.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/acting_lanes.hpp"
#include "dynamics/certain_decisions.hpp"
#include "dynamics/near_pairs.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Until when the decision of a pair holds (pair_decisions.hpp), [L].
struct DecisionLimits {
  double way = 0.0;  ///< until the ways (Swing) of its two blocks add up to this
  /// Until the ways of all blocks that either of them is paired with add up to this;
  /// infinite: they do not count.
  double ways = 0.0;
  double travel = 0.0;  ///< which they cannot before the travel is this
};
/// A contact of a pair, apart from its seat.
struct PairContact {
  CornerOnEdge at;
  bool asked = false;                ///< acts if its corner is inside its edge (19)
  bool decided = false;              ///< acts
  bool touches = false;              ///< acted in the step before
  double normal = 0.0, shear = 0.0;  ///< [F] of its springs
};
/// The contacts of some pairs: those of pair `pair[k]` are first[k] .. first[k + 1]-1.
struct ContactsOfPairs {
  std::vector<int> pair, first = {0};
  std::vector<PairContact> all;
  void clear() { pair.clear(), first.assign(1, 0), all.clear(); }
  void add(int p, const std::vector<PairContact>& contacts);
};

/// Force of a spring whose contact has ceased to act.
struct LostSpring {
  int pair;
  CornerOnEdge at;
  double normal, shear;  ///< [F] normal > 0
};

/// One thread decides all pairs of a window, and their lanes stand together.
inline constexpr int pairs_of_one_window = 256;
/// Pairs of one round.
inline constexpr int pairs_of_one_round = 8;

struct PairContacts : ActingLanes {
  std::vector<NearPair> pairs;       ///< ordered
  std::vector<int> first_of_block;   ///< (blocks + 1) where the pairs of a block begin
  std::vector<int> pairs_of_blocks;  ///< pairs of each block: their indices
  BlockParts parts;

  std::vector<DecisionLimits> limits;  ///< (pairs)
  std::vector<double> rounds;  ///< [L] (pairs / pairs_of_one_round, rounded up) travel
                               ///< (Swing) before which nothing has to be looked at
  std::vector<short> seats;    ///< (pairs) that its lane has to have
  std::vector<int> pair_of_lane;  ///< -1: idle
  bool loaded = false;            ///< the lanes know what acts
  bool read = false;              ///< the list of the model does, too, with readings
  bool list_is_behind = false;    ///< catch_up_pairs() has to come before anybody reads

  /// What one thread finds.
  struct Share {
    std::vector<LostSpring> lost;
    ContactsOfPairs unseated;  ///< decided, and more than their lanes have seats
    PairScratch scratch;
    std::vector<PairContact> before, now;  ///< of one pair
    std::vector<int> due;                  ///< pairs whose decisions no longer hold
    CertainDecisions decisions;
    Extremes extremes;
    unsigned long long exact_calls = 0;  ///< questions left to exact arithmetic
  };
  std::vector<Share> shares;  ///< (threads)
  // What all found together.
  std::vector<LostSpring> lost;
  ContactsOfPairs unseated, held;
  std::vector<int> heirs;  ///< sets whose contacts were handed some of it

  /// Takes the pairs of a new list. `known`: `held` has the contacts of the list
  /// before; those of pairs that the new one lacks are dropped (pair -1). `moved_only`:
  /// since then blocks have moved, and nothing else. All pairs have to be decided, for
  /// there may be new neighbours.
  void take(std::vector<NearPair>& found, const Blocks& blocks, bool rigid, int threads,
            bool known, bool moved_only);
  /// Contacts of a pair, in the order of the list: what is in its seats.
  void contacts_of(int p, std::vector<PairContact>& contacts) const;
  /// All that is in seats, pair by pair.
  void take_out(ContactsOfPairs& all) const;
  /// The acting contacts of a model, for the present pairs, which hold all of theirs.
  void take_from(const Blocks& blocks, const Contacts& contacts,
                 ContactsOfPairs& all) const;
  /// New lanes with these contacts; `later`: takes the place of all contacts of its
  /// pairs. No pair twice in either.
  void make_lanes(const Blocks& blocks, const Settings& settings,
                  const ContactsOfPairs& all, const ContactsOfPairs& later);
  /// Pair p is decided: these contacts act, or, if `asked`, those of them that are
  /// inside. Springs of others are lost.
  void seat(const Blocks& blocks, int p, const std::vector<CornerOnEdge>& found,
            bool asked, Share& share);
  /// Joins what the threads found; true: some pairs have no seats yet.
  bool join_shares();

  /// The ways of the two blocks of pair p together, [L].
  double ways_of_two(int p) const {
    return swing.way[pairs[p].low] + swing.way[pairs[p].high];
  }
  /// Those of all blocks that either of them is paired with, each of the two among
  /// them; how many these are.
  double ways_of_neighbours(int p) const;
  int neighbours_of(int p) const;
  /// By how much the travel may grow before the decision of pair p has to be looked at
  /// again, [L]; not positive: it no longer holds.
  double left_of(int p);

  /// What acts becomes the list of the model; forces and overlaps of the last step, or
  /// 0 without readings.
  void store(Contacts& contacts) const;

  /// Calls visit(block) for each block that block b is paired with, in the order of the
  /// list.
  template <class Visit> void each_neighbour(int b, const Visit& visit) const {
    for (int k = first_of_block[b]; k < first_of_block[b + 1]; ++k)
      visit(pairs[pairs_of_blocks[k]].beside(b));
  }
  /// Calls visit(seat) for each seat of a pair, in the order of the list.
  template <class Visit> void each_seat(int p, const Visit& visit) const {
    if (pairs[p].lane < 0)
      return;
    const LanePairs& set = lanes.pairs[pairs[p].lane / lane_count];
    for (int slot = set.first_slot; slot < set.first_slot + set.slots; ++slot)
      visit(slot * lane_count + pairs[p].lane % lane_count);
  }
  /// Calls visit(first, last) for pairs first .. last - 1 of each window.
  template <class Visit> void each_window(const Visit& visit) const {
    const int count = static_cast<int>(pairs.size());
    for (int first = 0; first < count; first += pairs_of_one_window)
      visit(first, std::min(count, first + pairs_of_one_window));
  }
  CornerOnEdge at(int seat) const {
    return {lanes.at(seat, &SlotPlaces::corner), lanes.at(seat, &SlotPlaces::edge)};
  }
  /// No contact: a corner never acts on its own edge.
  bool is_vacant(int seat) const { return at(seat).corner == at(seat).edge; }

 private:
  void set_seat(const Blocks& blocks, int p, int seat, const PairContact& contact);
  void make_sets_of_window(int first, int last);
};

/// For the contact rule: the blocks that a block is paired with.
struct Neighbours {
  const PairContacts& all;
  template <class Visit> void operator()(int block, const Visit& visit) const {
    all.each_neighbour(block, visit);
  }
};

}  // namespace blocks::dynamics
