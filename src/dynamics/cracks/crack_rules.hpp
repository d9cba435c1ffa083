// The two rules that make a block split (CRACK, docs/cracks.md#when-blocks-split): pure
// functions of one block.
#pragma once

#include <optional>
#include <vector>

#include "geometry/split.hpp"
#include "model/cracks.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// A crack that a rule demands.
struct CrackDemand {
  CrackCause cause = CrackCause::stress;
  double stress = 0.0;       ///< [F/L^2] that has reached the strength
  geometry::SplitLine line;  ///< where to cut; `near` is not set
};

/// A contact force on a block.
struct PointLoad {
  Vec2 at;     ///< [L]
  Vec2 force;  ///< [F]
};

/// Returns the largest principal value of the symmetric part of a tensor with rows 11,
/// 12, 21, 22.
double largest_principal(const Eigen::Vector4d& tensor);

/// Rule A. Returns the crack through the centroid of block b at right angles to its
/// largest principal stress, if that is at least rule.strength. The stress is the
/// internal one (12) or, for rigid blocks, the applied one (9). If both principal
/// stresses are equal, the crack is at right angles to the longest extent, and of equal
/// ones to that in x.
std::optional<CrackDemand> crack_by_stress(const Blocks& blocks, int b, bool rigid,
                                           const CrackRule& rule);

/// Rule B. Returns the cracks along the chords of two opposite contact forces F at a
/// distance D with 2 F / (pi D) >= rule.point_strength, the greatest stress first, and
/// of equal ones in the order of their pairs. Both forces act towards each other,
/// within 20 degrees of the chord; F is the lesser of their components along it. Chords
/// shorter than `shortest` [L] do not count. The direction of the line is the chord.
std::vector<CrackDemand> cracks_by_point_loads(const std::vector<PointLoad>& loads,
                                               double shortest, const CrackRule& rule);

}  // namespace blocks::dynamics
