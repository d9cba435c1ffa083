// Records of one corner against the edges of one block, which are decided together
// (rule 12), the pairs of blocks they belong to, and for how long decisions stand.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dynamics/acting_lanes.hpp"
#include "dynamics/give_back.hpp"
#include "dynamics/third_blocks.hpp"
#include "dynamics/watch_rows.hpp"
#include "model/contact_blocks.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// What is known of a group without deciding it again. `travel` [L]: while the two
/// blocks have moved against each other by less (relative_motion), the record
/// `candidate` acts if its corner is inside its edge (19), and no other one; -1: none
/// acts. 0: nothing is known.
struct Certainty {
  static constexpr int anywhere = -3;
  int candidate = -1;
  double travel = 0.0;
  /// Only while the corner is there in the block (PlaceInBlock::outside_of; edges are
  /// numbered within the block), and, asks,
  /// while the edge comes through or no side crosses (ContactDecision::stands).
  int place = anywhere;
  bool asks = false;
  ThirdsAway away;  ///< only while third blocks are
};

/// What is asked in each step of a group that is certain on a condition.
struct Watch {
  /// Edges of the group's block, numbered within it, that its corner may pass; -1:
  /// none.
  std::array<int, 2> edges = {-1, -1};
  /// What keeps the sides before and after the edge it is outside of from crossing
  /// (CrossingSides::apart); 0: that is not asked.
  std::array<unsigned, 2> apart = {0, 0};

  static constexpr int bits = 16;
  Watch() = default;
  explicit Watch(std::uint32_t packed)
      : edges{static_cast<int>(packed & 63U) - 1,
              static_cast<int>(packed >> 6 & 63U) - 1},
        apart{packed >> 12 & 3U, packed >> 14 & 3U} {}
  std::uint32_t packed() const {
    const auto word = [](int edge) { return static_cast<std::uint32_t>(edge + 1); };
    return word(edges[0]) | word(edges[1]) << 6 | apart[0] << 12 | apart[1] << 14;
  }
};

/// Records first .. last() - 1 of the contact list: one corner, edges of one block.
/// Many: 24 bytes.
struct ContactGroup {
  static constexpr std::uint32_t most_records = geometry::most_corners;  ///< edges
  static constexpr int most_edges = 60;  ///< of a block, for a condition
  /// None, and none as long as there are no lanes.
  static constexpr int no_seat = -1, seat_wanted = -2;
  static constexpr unsigned most_hopeless = (1U << 6) - 1;
  int first = 0;
  std::uint32_t count : 15 = 0;  ///< records
  std::uint32_t nth : 15 = 0;    ///< of them is record(), from 1; 0: none
  /// The edges' block is not convex: the group after this one holds the same records,
  /// for the second edge of a notch.
  std::uint32_t reentrant : 1 = 0, of_notch : 1 = 0;
  std::uint32_t hopeless : 6 = 0;   ///< decisions left for which none is certain
  std::uint32_t asks : 1 = 0;       ///< of its certainty
  std::uint32_t low_edges : 1 = 0;  ///< the edges are those of the pair's lower block
  std::uint32_t place_from_anywhere : 6 = 0;  ///< place()
  std::uint32_t watched : Watch::bits = 0;    ///< watch(), where it is prompt
  int seat = no_seat;    ///< of its contact (ContactLanes), >= 0 where it has one
  float travel = 0.0F;   ///< [L] of its certainty, from the pose of its pair
  float unasked = 0.0F;  ///< [L] the same, until what it stands on has to be asked

  int last() const { return first + static_cast<int>(count); }
  bool certain() const { return travel > 0.0F; }
  /// Certain on a condition.
  bool conditional() const { return place_from_anywhere != 0; }
  /// Of its certainty.
  int place() const {
    return static_cast<int>(place_from_anywhere) + Certainty::anywhere;
  }
  /// While it is prompt.
  Watch watch() const { return Watch(watched); }
  void set(const Watch& watch) { watched = watch.packed() & ((1U << Watch::bits) - 1); }
  /// Until it has to be looked at, [L]: 0 where it is not certain.
  float lasts() const { return conditional() ? std::min(travel, unasked) : travel; }
  /// That acts, -1: none; while certain: that is the candidate to.
  int record() const { return nth > 0 ? first + static_cast<int>(nth) - 1 : -1; }
  void set_record(int i) {
    nth = i < 0 ? 0 : static_cast<std::uint32_t>(i - first + 1) & most_records;
  }
  void set(const Certainty& known);
  /// Nothing is certain of it, nor what acts.
  void forget();
};
static_assert(sizeof(ContactGroup) == 24 &&
              ContactGroup::most_records == (1U << 15) - 1);

/// The block of a group's edges.
inline int edge_block(const Blocks& blocks, const Contacts& contacts,
                      const ContactGroup& group) {
  return blocks.corner_block[contacts.edge[group.first]];
}

/// A travel that is kept: a float that is no longer, or NaN, which keeps nothing.
inline float rounded_down(double travel) {
  return static_cast<float>(travel - 0x1p-23 * std::abs(travel));
}

/// The groups of two blocks, which stand side by side.
struct ContactPair {
  int low = 0, high = 0;  ///< the two blocks
  int first = 0;          ///< group; its last is before the first of the next pair
  /// Of its contacts that have seats (ContactLanes); between make_lanes() and load(),
  /// where there are none: how many get one.
  int lane = -1;
  std::uint32_t prompt = 0;  ///< bit k: an edge of group first + k is asked in
                             ///< each step

  /// The one that is not this block.
  int beside(int block) const { return low == block ? high : low; }
  /// The block of the edges of one of its groups.
  int edge_block(const ContactGroup& group) const {
    return group.low_edges ? low : high;
  }
  /// Of group g in `prompt`; 0: the pair has too many groups.
  std::uint32_t bit(int g) const {
    return g - first < 32 ? std::uint32_t{1} << (g - first) : 0U;
  }
};

/// What the prompt groups of a pair watch.
struct WatchedEdges {
  std::uint32_t prompt;
  std::array<std::uint32_t, 32> of;  ///< of prompt ones only: place and watch

  bool operator==(const WatchedEdges& other) const {
    bool same = prompt == other.prompt;
    for (std::uint32_t bits = prompt; same && bits != 0; bits &= bits - 1)
      same = of[std::countr_zero(bits)] == other.of[std::countr_zero(bits)];
    return same;
  }
};

/// How the two blocks of a pair stood to each other when certainty began to count.
struct PairPose {
  double x = 0.0, y = 0.0;                   ///< [L] between the centroids
  double angle_low = 0.0, angle_high = 0.0;  ///< rad
  float sum = 0.0F;      ///< [L] of both blocks' swing, rounded down
  float certain = 0.0F;  ///< [L] until the first of the pair's groups has to be decided
};
static_assert(sizeof(ContactPair) + sizeof(PairPose) == 60);
/// Pairs with as many contacts share a set of lanes where they are of so many in the
/// list: the blocks of a set are near each other in the memory. One thread decides all
/// of a window.
inline constexpr int pairs_of_window = 256;

/// So many pairs have one limit together: none of their limits is reached while the
/// travel (Swing) is less.
inline constexpr int pairs_of_round = 8;
inline constexpr int rounds_of_window = pairs_of_window / pairs_of_round;

/// The spring of a seat whose contact acts.
struct HeldSpring {
  int record = -1;                   ///< -1: it does not act
  double normal = 0.0, shear = 0.0;  ///< [F] FN, FS
};

/// Elastic force that a record held when it ceased to act.
struct LostForce {
  int group, record;
  double normal, shear;  ///< [F] FN > 0, FS
};

/// Sets first .. last - 1 of lanes.
struct SetRange {
  int first = 0, last = 0;
};

/// Gives the memory of the slots back, set after set, as what acts in them is stored in
/// the list: in the step in which it passes from the one to the other a large model has
/// no room for both.
class StoredLanes {
 public:
  explicit StoredLanes(const ContactLanes& lanes);
  /// All before this set are stored.
  void passed(int set);

 private:
  const ContactLanes& lanes_;
  Wake places_, springs_, advanced_;
};

/// The groups of a list, and for how long their decisions stand.
struct DecidedGroups {
  std::vector<ContactGroup> all;  ///< in the order of the list
  std::vector<ContactPair> pairs;
  std::vector<PairPose> poses;     ///< (pairs)
  std::vector<PairShapes> shapes;  ///< (pairs) deformable blocks only
  /// [L] (pairs) No decision of a pair has to be renewed while the ways of its two
  /// blocks (Swing) add up to less: a quick look before relative_motion.
  std::vector<float> limits;

  /// The groups of a pair end before this one.
  int end_of(int pair) const {
    const auto next = static_cast<std::size_t>(pair) + 1;
    return next < pairs.size() ? pairs[next].first : static_cast<int>(all.size());
  }
};

/// The groups, and what passes between them. Working state between searches: not part
/// of the model, and without influence on results.
struct ContactGroups : DecidedGroups, ActingLanes {
  std::vector<double> rounds;  ///< [L] (pairs / pairs_of_round, rounded up)
  /// (rounds) bit k: groups of the round's pair k are prompt
  std::vector<std::uint8_t> prompt;
  WatchRows watches;                  ///< of the prompt ones
  ThirdBlocks thirds;                 ///< that certain groups count on
  std::vector<int> pairs_of_corners;  ///< in which a corner has a group: their indices
  std::vector<int> first_of_corner;   ///< (corners + 1) where those of a corner begin

  // What acts, or is a candidate to, has a seat (ContactLanes), those of a pair in the
  // order of the list. Between load() and store() the lanes know what acts, else the
  // list does: never both.
  std::vector<int> record;      ///< (seats) -1: none any more
  bool seats_complete = false;  ///< no group lacks a seat
  int times_made = 0;           ///< lanes, of this list
  double made_at = 0.0;         ///< [L] the travel (Swing) when they were made last
  bool loaded = false;          ///< the lanes know what acts, not the list
  bool read = false;            ///< the list does, with readings of the last step

  std::vector<LostForce> lost;  ///< in this step
  std::vector<int> heirs;       ///< sets whose contacts were handed some of it
  /// What one thread finds.
  struct Share {
    std::vector<LostForce> lost;
    bool seats_complete = true;
    Extremes extremes;
    unsigned long long exact_calls = 0;
  };
  std::vector<Share> shares;  ///< (threads)

  /// Forgets all and gives its memory back, for a list that is to be made.
  void give_back();
  /// All decisions have to be renewed.
  void forget_decisions();
  /// Calls visit(block) for each convex block with edges in the list for the corner,
  /// but that of the surface.
  template <class Visit>
  void each_third(const Blocks& blocks, const ThirdsAway::Place& place,
                  const Visit& visit) const {
    const int c = place.corner, own = blocks.corner_block[c];
    for (int k = first_of_corner[c]; k < first_of_corner[c + 1]; ++k)
      if (const int third = pairs[pairs_of_corners[k]].beside(own);
          third != blocks.corner_block[place.surface] && blocks.convex[third])
        visit(third);
  }
  /// Watches the third blocks that the certainty of group g of pair p counts on. False:
  /// there is no room.
  bool watch_thirds(const Blocks& blocks, int p, int g, const ThirdsAway& away);
  /// The seat of the group's contact that acts in this step, or -1.
  int acting(int g) const {
    const int seat = all[g].seat;
    return seat >= 0 && lanes.is(seat, &SlotPlaces::touches) ? seat : -1;
  }
  /// What the prompt groups of a pair watch.
  WatchedEdges watched_by(const ContactPair& pair) const;
  /// Certainty of a pair counts from here on.
  void take_pose(const Blocks& blocks, int pair);
  /// Bound on how far the two blocks of a pair have moved against each other since: no
  /// difference of two of their corners, or of a corner and a centroid, has changed by
  /// more, [L]: two of one block by its arms alone. A distance: from one pose to a
  /// third never farther than by way of a second.
  double relative_motion(const Blocks& blocks, int pair) const;
  /// Springs from the list to the lanes, and the dashpots; the lanes first where there
  /// are none.
  void load(const Blocks& blocks, Contacts& contacts, const Settings& settings);
  /// Springs from the lanes to the list, unless they are there. Without readings of the
  /// last step forces and overlaps are 0.
  void store(Contacts& contacts);
  /// What acts in group g, with its readings (contact_readings.hpp) or without, becomes
  /// the last of the list.
  void store(Contacts& contacts, int g, bool with_readings) const;
  /// Of the record in a seat.
  int group_of(int seat) const;
  HeldSpring held(int seat) const;
  /// Puts record i of group g, or none (-1), and its spring into the seat of the group.
  /// False: it has none.
  bool set_seat(const Blocks& blocks, const Contacts& contacts, int g, int i,
                const HeldSpring& spring);
  /// The same where its seat holds that very record, or none, already: what is in it
  /// stays. False: it does not.
  bool keep_seat(int g);
  /// Makes one of what the threads found.
  void join_shares();
  /// Memory for the case that all groups act.
  void reserve_lanes(bool rigid);
  /// A seat for each group that has one, acts or may act; from the second time on also
  /// for those that may act as soon again as seats have run out. They get it when they
  /// are loaded.
  void make_lanes(const Contacts& contacts);
  /// Calls visit(first, last) for pairs first .. last - 1 of each window.
  template <class Visit> void each_window(const Visit& visit) const {
    const int count = static_cast<int>(pairs.size());
    for (int first = 0; first < count; first += pairs_of_window)
      visit(first, std::min(count, first + pairs_of_window));
  }
  /// The sets in which the pairs of a window, from `first` on, have their lanes.
  SetRange sets_of(int first) const {
    const int window = first / pairs_of_window;
    return {first_set[window], first_set[window + 1]};
  }

 private:
  /// What acts in group g, from the list.
  void load(const Blocks& blocks, const Contacts& contacts, int g,
            const ActingContact& contact);
  /// For those of pairs first .. last - 1 whose seat is not -1.
  void seat_window(int first, int last);
};

struct EarlierGroups;
/// Records first .. last - 1 of the list.
struct RecordRange {
  int first = 0, last = 0;
};

/// Adds the groups of these records, and their pairs. each_alone: one record each.
void add_groups(const Blocks& blocks, const Contacts& contacts, RecordRange records,
                ContactGroups& groups, bool each_alone = false);

/// Splits the list into its groups and pairs, all to be decided, but for what is known
/// from the list before. each_alone: one record each, for studies without the nearest
/// edge.
void group_contacts(const Blocks& blocks, const Contacts& contacts, bool rigid,
                    ContactGroups& groups, bool each_alone = false, int threads = 1,
                    EarlierGroups* earlier = nullptr);

}  // namespace blocks::dynamics
