// Pairs of blocks whose contacts may act, one pair to a SIMD lane: where they stand,
// and plain arithmetic on them, compiled for each instruction set that the processor
// may have. No fused multiply-add, no reassociation: every set gives the same bits
// (tests/dynamics/contact_lanes_test.cpp).
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "dynamics/contact_law.hpp"

namespace blocks::dynamics {

/// Lanes are handled in sets of so many: one register of AVX-512, two of AVX2.
inline constexpr int lane_count = 8;

/// Yes or no of each lane of a set: bit k of lane k.
using LaneBits = std::uint8_t;
/// A number of each lane of a set.
template <class Number> using LaneRow = Number[lane_count];

/// The pairs of a set: in each lane two blocks, low and high by number.
struct alignas(64) LanePairs {
  LaneRow<int> low, high;
  LaneRow<double> damping;  ///< [F T/L] C of (18), one for all contacts of a pair
  int first_slot, slots;    ///< the contacts of the set
  bool ends;                ///< a contact of the set has ceased to act
  bool in_doubt;            ///< a sign is too near zero for the lanes
};
/// A slot: one contact of each pair of a set.
struct SlotPlaces {
  LaneRow<int> corner, edge, edge_end;  ///< corners of the model
  // how it is known whether the contact acts; neither: it does not
  LaneBits asked;    ///< if the corner is inside the edge, (19), and between its ends
  LaneBits decided;  ///< it does
  // whether it does in this step
  LaneBits touches;
  LaneBits starts;    ///< did not in the step before, or took over
  LaneBits ends;      ///< did in the step before, and does not now
  LaneBits in_doubt;  ///< taken to touch, but (19) or "between" is too near zero
  LaneBits flips;     ///< the edge is the low block's
};
/// What is kept from step to step.
struct alignas(64) SlotSprings {
  LaneRow<double> normal_elastic, shear_elastic;  ///< [F]
};
/// What the contacts of a pair do to its blocks in a step: fetched pair by pair.
struct alignas(32) PairForce {
  double fx, fy;                   ///< [F] on the low block
  double moment_low, moment_high;  ///< [F L]
};
/// Sums of f_i x_j, arms from the two centroids, [F L]: 11, 12, 21, 22 of both blocks.
struct alignas(64) PairStress {
  double low[4], high[4];
};
/// What else a step finds, for whoever reads the model.
struct alignas(64) SlotReadings {
  LaneRow<double> overlap;                    ///< [L] >= 0
  LaneRow<double> normal_force, shear_force;  ///< [F] 0 where apart
};

/// All sets and slots. What one computation needs stands side by side in the memory.
struct LaneSets {
  LanePairs* pairs = nullptr;
  PairForce* forces = nullptr;     ///< (lanes)
  PairStress* stresses = nullptr;  ///< (lanes)
  SlotPlaces* places = nullptr;
  SlotSprings* springs = nullptr;   ///< at the start of the step
  SlotSprings* advanced = nullptr;  ///< at its end
  // those of the sets that are read, from these on
  SlotReadings* readings = nullptr;
  int first_reading = 0, first_stress = 0;
};

/// The sets and their memory. Pair k of a set has the lane 8 set + k, its contact in a
/// slot the seat 8 slot + k.
class ContactLanes : public LaneSets {
 public:
  int sets() const { return sets_; }
  int slots() const { return slots_; }
  /// What is reserved.
  struct Room {
    int sets = 0, slots = 0;
    int read_sets = 0, read_slots = 0;  ///< read at once
  };
  /// Memory for so many, which is not touched before it is used. Stresses of rigid
  /// blocks are for readers only.
  void reserve(const Room& room, bool rigid);
  /// None.
  void clear() { sets_ = slots_ = 0; }
  /// One set more, with so many slots: all of them idle. Its number.
  int add_set(int slots);

  /// Readings begin at this set; stresses of rigid blocks too.
  void read_from(int set, bool rigid);
  /// The set of a slot.
  int set_of(int slot) const;
  /// What the springs have become is what the next step starts with.
  void advance_springs() { std::swap(springs, advanced); }

  /// A number of one lane or seat: at(seat, &SlotPlaces::corner).
  template <class Part, class Number>
  Number& at(int i, LaneRow<Number> Part::*row) const {
    return (part(static_cast<Part*>(nullptr))[i / lane_count].*row)[i % lane_count];
  }
  /// A bit of one seat.
  bool is(int seat, LaneBits SlotPlaces::*bits) const {
    return (places[seat / lane_count].*bits >> seat % lane_count & 1U) != 0;
  }
  void set(int seat, LaneBits SlotPlaces::*bits, bool yes) {
    LaneBits& all = places[seat / lane_count].*bits;
    const unsigned bit = 1U << seat % lane_count;
    all = static_cast<LaneBits>(yes ? all | bit : all & ~bit);
  }

 private:
  LanePairs* part(LanePairs*) const { return pairs; }
  SlotPlaces* part(SlotPlaces*) const { return places; }
  SlotSprings* part(SlotSprings*) const { return springs; }

  int sets_ = 0, slots_ = 0;
  Room room_;
  int room_for_stresses_ = 0;
  std::unique_ptr<LanePairs[]> own_pairs_;
  std::unique_ptr<PairForce[]> own_forces_;
  std::unique_ptr<PairStress[]> own_stresses_;
  std::unique_ptr<SlotPlaces[]> own_places_;
  std::unique_ptr<SlotSprings[]> own_springs_, own_advanced_;
  std::unique_ptr<SlotReadings[]> own_readings_;
};

/// What is read of the blocks.
struct BlockRows {
  const double *corner, *centroid, *velocity, *spin, *strain_rate;
};

/// The largest overlap and elastic normal force.
struct LaneExtremes {
  double overlap, spring;
};

struct PartPairs;
struct FacingAnswers;

/// The computations for one instruction set, for the sets of lanes first .. last-1.
struct LaneArithmetic {
  std::string_view name;  ///< baseline, avx2, avx512
  /// Which contacts touch, `touches`, `starts`, `ends` and `in_doubt`, and what they
  /// do. Sets in doubt have to be settled and to act again; they are not among the
  /// extremes.
  LaneExtremes (*touch_and_act)(const LaneSets&, const BlockRows&, const ContactLaw&,
                                bool rigid, int first, int last);
  /// What those do that touch: a.-e. of rule 7. readings: also SlotReadings, and
  /// PairStress of rigid blocks.
  LaneExtremes (*act)(const LaneSets&, const BlockRows&, const ContactLaw&, bool rigid,
                      bool readings, int first, int last);
  /// Which faces of pairs of parts act (facing_lanes.hpp).
  void (*find_faces)(const PartPairs&, const BlockRows&, FacingAnswers&);
};

/// All that this processor can run; the first is the baseline.
const std::vector<LaneArithmetic>& all_lane_arithmetic();

/// The widest of them, or what the environment variable BLOCKS_SIMD names. Throws
/// std::invalid_argument that lists them where there is no such one: ask for them once
/// before the first step.
const LaneArithmetic& lane_arithmetic();

}  // namespace blocks::dynamics
