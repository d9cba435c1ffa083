// What acts between two blocks, and why: the results of the exact rule for `blocks why`
// and for the audit.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "audit/third_part.hpp"

namespace blocks::audit {

/// A corner, by its index in a part.
struct PartCorner {
  int part = -1, index = -1;
};

/// A side of a part, from corner number `start` to `end`, clockwise.
struct PartSide {
  int part = -1, index = -1;
  int start = -1, end = -1;
  bool inner = false;  ///< it is between two parts of one block
  bool operator==(const PartSide&) const = default;
};

/// What the depth of a far axis is compared with.
enum class Bound { separating_shift, common_diameter, third_part };

/// Twice the largest of the bounds that a far axis exceeds.
struct FarBound {
  Bound bound = Bound::separating_shift;
  double twice = 0.0;  ///< [L]
};

/// A third part at the contact point that blocks the shift out of the axis.
struct Blocking {
  /// A slide along the side until the third part is left.
  struct Slide {
    double length = 0.0;  ///< [L]
    double rest = 0.0;    ///< [L] of the side after the slide
  };
  int part = -1;
  ThirdOf whose = ThirdOf::own;
  double overlap = 0.0;  ///< [L] depth of its overlap after the shift
  Slide shorter, longer;
  bool hides = false;
};

/// A side and the deepest corner of the other part, with what the rule has determined
/// about them.
struct Axis {
  PartSide side;
  PartCorner deepest;
  int corner = -1;     ///< number of this corner
  double depth = 0.0;  ///< [L]
  int depth_sign = 0;
  std::optional<PartSide> facing;
  /// The members below have been determined, and a facing side that does not cross has
  /// been dropped.
  bool examined = false;
  bool skipped = false;         ///< of an inner side
  std::optional<FarBound> far;  ///< only if it is not skipped
  /// Only if it is not skipped and not far. If a third part hides it, that is the last
  /// one.
  std::vector<Blocking> blocking;
  bool hidden() const;
};

/// Why a side has no end where the foot of a corner is beyond it.
enum class NoEnd { notch, joint };

/// A corner and a side that may form a contact, with the result of each test.
struct Candidate {
  int corner = -1;
  PartSide side;
  double depth = 0.0;  ///< [L]
  bool inside = false, between = false;
  std::optional<NoEnd> no_end;  ///< tested only if `between` is false
  int third = -1;               ///< the part at the notch or joint
  bool far = false;             ///< tested unless the side is an inner one
  bool acts = false;
};

/// What acts between two parts.
enum class Choice {
  apart,     ///< nothing: a side separates them by more than the slack
  touching,  ///< the least axis: its side separates them
  axis,      ///< the first axis that is neither skipped nor far nor hidden
  least_axis,     ///< the least axis: there is no such axis, and no third part carries
  none,      ///< nothing: a third part carries one of the two
};

/// The decision about two convex parts.
struct PartDecision {
  int part = -1, other = -1;
  Choice choice = Choice::apart;
  PartSide separating;      ///< the side that separates parts that are apart
  double separation = 0.0;  ///< [L] depth of that axis, below zero
  std::vector<Axis> axes;   ///< in ascending order of depth
  int chosen = -1;          ///< an index into axes; -1: apart, or no axis is left
  int carrier = -1;         ///< the third part that carries, if nothing acts
  std::vector<Candidate> candidates;
};

/// The decision about two blocks.
struct PairDecision {
  std::vector<PartDecision> parts;
  /// The corner and the edge (its first corner) of each acting contact, in ascending
  /// order.
  std::vector<std::pair<int, int>> contacts;
};

}  // namespace blocks::audit
