// Pairs of blocks that are near each other, what was decided of them and for how long
// that holds, and their contacts, which stand in lanes (contact_lanes.hpp). Working
// state: not part of the model, and without influence on results.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/acting_lanes.hpp"
#include "dynamics/near_pairs.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// How two blocks stood to each other when something was decided of them.
struct PairPlacement {
  double x = 0.0, y = 0.0;                   ///< [L] between the centroids
  double angle_low = 0.0, angle_high = 0.0;  ///< rad
  double sum = 0.0;                          ///< [L] of both blocks' swing
  double ways = 0.0;  ///< [L] of all blocks with which either of them is paired
};
/// For how long a decision holds.
struct DecisionRoom {
  double room = 0.0;       ///< [L] while blocks have moved by less; 0: for one step
  unsigned char life = 6;  ///< log2 of the steps for which room is tried next
  unsigned char wait = 0;  ///< decisions until room is tried again
  /// [L] Likewise, while blocks have moved by less against their neighbours; 0: they do
  /// not count.
  double room_of_neighbours = 0.0;
  /// [L] Likewise, for what corners are between the ends of their edges (ask_ends).
  double room_of_ends = 0.0;
};
struct KeptDecision : PairPlacement, DecisionRoom {};
/// [L] A decision has not to be looked at before the ways of its two blocks (Swing) add
/// up to `way`, or the travel has grown to `travel`.
struct PairLimits {
  double way = 0.0, travel = 0.0;
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

  std::vector<KeptDecision> kept;  ///< (pairs)
  std::vector<PairShapes> shapes;  ///< (pairs) deformable blocks only
  std::vector<PairLimits> limits;  ///< (pairs)
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
  /// there may be new neighbours; for how long decisions held is kept.
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
  /// Finds which contacts in the seats of pair p, which is settled, are between the
  /// ends of their edges: no others may act. What is left of its rooms counts from here
  /// on.
  void ask_ends(const Blocks& blocks, int p);
  /// The same for a pair that has been decided in this step and got its seats only now.
  void open_ends(const Blocks& blocks, int p);
  /// Joins what the threads found; true: some pairs have no seats yet.
  bool join_shares();

  /// The decision of pair p counts from here on.
  void place(const Blocks& blocks, int p);
  /// What is left of the room of a pair: no difference of two corners of its blocks, or
  /// of a corner and a centroid, can have changed by more than the rest, [L].
  double room_left(const Blocks& blocks, int p) const;
  /// The same with the neighbours of the two blocks.
  double room_of_neighbours_left(int p) const;
  /// How much more a difference of two stored corners of pair p may change, [L]: each
  /// corner is rounded to the last place of its coordinates. The rooms do not count it.
  double rounding(const Blocks& blocks, int p) const;
  /// How many ways of blocks count for pair p and its neighbours.
  int ways(int p) const;

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
  double sum_of_ways(int p) const;
};

}  // namespace blocks::dynamics
