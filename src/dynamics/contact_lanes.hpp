// The contacts that may act, one to a SIMD lane: where they stand, and plain arithmetic
// on them, compiled for each instruction set that the processor may have. No fused
// multiply-add, no reassociation: every set gives the same bits
// (tests/dynamics/contact_lanes_test.cpp).
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "dynamics/contact_law.hpp"

namespace blocks::dynamics {

/// Lanes are handled in sets of so many: one register of AVX-512, two of AVX2.
inline constexpr int lane_count = 8;

/// How it is known whether the contact in a lane acts.
inline constexpr double idle = 0.0,  ///< it does not
    by_sign = 1.0,                   ///< if the corner is inside the edge, (19)
    decided = 2.0;                   ///< it does
/// Whether it does in this step.
inline constexpr double apart = 0.0, in_touch = 1.0,
                        starting =
                            2.0;  ///< it did not in the step before, or took over

/// A property of the contacts of a set.
template <class Number> using LaneRow = Number[lane_count];

/// What contacts are. Side a is the corner's block, side b the edge's.
struct alignas(64) LanePlaces {
  LaneRow<double> rule;                 ///< idle, by_sign, decided
  LaneRow<double> touch;                ///< apart, in_touch, starting
  LaneRow<int> corner, edge, edge_end;  ///< corners of the model
  LaneRow<int> corner_block, edge_block;
  int look;  ///< 1: a sign is in doubt, or a spring has lost its contact
};
/// What is kept from step to step.
struct alignas(64) LaneSprings {
  LaneRow<double> normal_elastic, shear_elastic;  ///< [F]
  LaneRow<double> damping;                        ///< [F T/L] C of (18)
};
/// What blocks feel in a step; low and high are the two by number.
struct alignas(64) LaneForces {
  LaneRow<double> fx, fy;                   ///< [F] on the low block, 0 where apart
  LaneRow<double> moment_low, moment_high;  ///< [F L]
};
/// What else a step finds, for whoever reads the model.
struct alignas(64) LaneReadings {
  LaneRow<double> low_x, low_y, high_x, high_y;  ///< [L] arms from the two centroids
  LaneRow<double> overlap;                       ///< [L] >= 0
  LaneRow<double> normal_force, shear_force;     ///< [F] 0 where apart
};

/// All sets. What one computation needs stands side by side in the memory.
struct LaneSets {
  LanePlaces* places = nullptr;
  LaneSprings* springs = nullptr;
  LaneForces* forces = nullptr;
  LaneReadings* readings = nullptr;
};

/// The sets and their memory.
class ContactLanes : public LaneSets {
 public:
  int size() const { return size_; }
  int sets() const { return (size_ + lane_count - 1) / lane_count; }
  /// Memory for so many lanes, which is not touched before it is used.
  void reserve(int lanes);
  /// So many lanes of those, all idle.
  void resize(int size);

  /// A number of one lane: at(lane, &LaneReadings::overlap).
  template <class Part, class Number>
  Number& at(int lane, LaneRow<Number> Part::*row) const {
    return (part(static_cast<Part*>(nullptr))[lane / lane_count].*
            row)[lane % lane_count];
  }

 private:
  LanePlaces* part(LanePlaces*) const { return places; }
  LaneSprings* part(LaneSprings*) const { return springs; }
  LaneForces* part(LaneForces*) const { return forces; }
  LaneReadings* part(LaneReadings*) const { return readings; }

  int size_ = 0, room_ = 0;  ///< lanes; sets
  std::unique_ptr<LanePlaces[]> own_places_;
  std::unique_ptr<LaneSprings[]> own_springs_;
  std::unique_ptr<LaneForces[]> own_forces_;
  std::unique_ptr<LaneReadings[]> own_readings_;
};

/// What is read of the blocks.
struct BlockRows {
  const double *corner, *arm, *centroid, *velocity, *spin, *strain_rate;
};

/// The largest overlap and elastic normal force.
struct LaneExtremes {
  double overlap, spring;
};

/// The two computations for one instruction set, for the sets of lanes first .. last-1.
struct LaneArithmetic {
  std::string_view name;  ///< baseline, avx2, avx512
  /// Which contacts touch: `touch` and `look`.
  void (*find_touching)(const LaneSets&, const BlockRows&, int first, int last);
  /// a.-d. of rule 7.
  LaneExtremes (*act)(const LaneSets&, const BlockRows&, const ContactLaw&, bool rigid,
                      int first, int last);
};

/// All that this processor can run; the first is the baseline.
const std::vector<LaneArithmetic>& all_lane_arithmetic();

/// The widest of them, or what the environment variable BLOCKS_SIMD names. Throws
/// std::invalid_argument that lists them where there is no such one: ask for them once
/// before the first step.
const LaneArithmetic& lane_arithmetic();

}  // namespace blocks::dynamics
