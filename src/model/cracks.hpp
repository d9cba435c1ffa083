// The record of cracks: which blocks have split, and which ones could not
// (docs/cracks.md#the-record).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks {

using geometry::Vec2;

/// The rule that made a block split.
enum class CrackCause : int {
  stress = 0,       ///< its largest principal stress
  point_loads = 1,  ///< two opposite contact forces
};

/// One block that has split in two.
struct CrackRecord {
  long step = 0;      ///< number of steps made
  double time = 0.0;  ///< [T]
  int parent = 0;     ///< the larger piece, which keeps the number of the block; from 0
  int child = 0;      ///< the other piece, a new block; from 0
  CrackCause cause = CrackCause::stress;
  double stress = 0.0;              ///< [F/L^2] that reached the strength of the rule
  Vec2 from = {0, 0}, to = {0, 0};  ///< [L] ends of the chord at that time
  double moved =
      0.0;  ///< [L] largest distance from a crossing to the corner it moved to
  double parent_area = 0.0, child_area = 0.0;  ///< [L^2] of the two pieces
  // [F L] of the block, and of both pieces together; kinetic: with spin and strain
  // rates
  double kinetic_before = 0.0, kinetic_after = 0.0;
  double strain_before = 0.0, strain_after = 0.0;

  /// Returns the length of the chord, [L].
  double length() const { return (to - from).norm(); }
  /// Returns the direction of the chord against the x axis, degrees, 0 <= angle < 180.
  double angle() const;
  /// Returns the energy that the crack has released, [F L].
  double released() const {
    return kinetic_before + strain_before - kinetic_after - strain_after;
  }
};

/// Why a block whose strength was reached did not split.
enum class CrackRefusal : int {
  small = 0,    ///< a piece would be smaller than amin
  thin = 1,     ///< a piece would be too thin for the time step
  corners = 2,  ///< a piece would have more corners than START allows
  full = 3,     ///< the model has as many blocks as START allows
  unsound = 4,  ///< the certificate of the cut does not hold
};
inline constexpr int crack_refusals = 5;

/// A block that did not split, once for each reason.
struct RefusedCrack {
  int block = 0;  ///< from 0
  CrackRefusal why = CrackRefusal::small;
  auto operator<=>(const RefusedCrack&) const = default;
};

/// Returns in how many blocks a crack was refused for this reason.
std::size_t count_refused(const std::vector<RefusedCrack>& all, CrackRefusal why);
/// Adds a refusal. Returns whether it is new.
bool refuse_crack(std::vector<RefusedCrack>& all, const RefusedCrack& refused);
/// Returns the reason in words: "a piece would be smaller than amin".
const char* describe(CrackRefusal why);

}  // namespace blocks
