// Decides independently which contacts act between two blocks. It follows
// docs/contact-rule.md in exact integers, and shares no code with the rule of the
// program (src/dynamics/rules) or its predicates.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audit/whole_numbers.hpp"
#include "model/blocks.hpp"

namespace blocks::audit {

/// An exact fraction. It is a position along a side, in units of the side's length.
using Ratio = boost::multiprecision::number<
    boost::multiprecision::rational_adaptor<Whole::backend_type>,
    boost::multiprecision::et_off>;

/// A convex part of a block, given by its corner numbers, clockwise.
struct ConvexPart {
  int block = 0;
  std::vector<int> corners;
};

/// Returns a sentence that says why these parts do not tile the block, or an empty
/// string if they do. The parts tile it if they are convex, have only corners of the
/// block, do not overlap and leave no gap. Parts without area may be missing.
std::string fault_of_parts(const Blocks& blocks, int block,
                           const std::vector<ConvexPart>& parts);

/// A side of a part, from corner number `start` to `end`, clockwise.
struct PartSide {
  int part = -1, index = -1;
  int start = -1, end = -1;
  bool inner = false;  ///< it is between two parts of one block
  bool operator==(const PartSide&) const = default;
};

/// How much of a side is covered by the neighbours of part B, where B is.
struct Cover {
  bool covered = false;
  double stretch = 0.0;   ///< [L] length from the joint to the far end of the interval
  double interval = 0.0;  ///< [L] length of the part of the side that lies in B
  double share_of_stretch = 0.0, share_of_interval = 0.0;  ///< covered fractions
  std::optional<PartSide> side;  ///< the covering side, if any side covers
};

/// A joint: a corner of a part with the two sides that meet there. It is closed if the
/// block beside it continues the surface.
struct Joint {
  int corner = -1;
  PartSide side, surface;
  int against_part = -1;        ///< the part against which the joint is tested
  bool surface_inner = false;   ///< then there is no surface, and the joint is open
  bool centroid_below = false;  ///< the centroid of that part is inside the surface
  Cover cover;
  bool closed = false;
};

/// The clause by which an axis is entered, or none.
enum class Entry { none, inside, other_end, foot, crossing };

/// The closed joints that hide a corner from a side of another part, and whether the
/// surface rises.
struct HiddenCorner {
  std::vector<Joint> joints;
  bool rises = false;  ///< the surface rises beyond a closed joint at the corner
  bool rise_keeps_it_visible = false;  ///< the side faces the rising surface
  bool hidden() const { return !joints.empty(); }
};

/// The location of a closed joint that hides an axis: an end of the axis side, an end
/// of the facing side, or the corner of the axis.
enum class HidingPlace { axis_side, facing_side, corner };

/// A closed joint that hides an axis.
struct HidingJoint {
  HidingPlace place = HidingPlace::axis_side;
  Joint joint;
  int surface = -1;  ///< index in PartDecision::axes of the axis of its surface
};

/// A side and the deepest corner of the other part, with what the choice has determined
/// about them.
struct Axis {
  PartSide side;
  int corner = -1;
  int corner_part = -1, corner_index = -1;
  double depth = 0.0;  ///< [L]
  int depth_sign = 0;
  std::optional<PartSide> facing;
  bool entry_known = false;  ///< `far` and `entry` have been determined
  bool far = false;          ///< deeper than the overlap region; then it is not entered
  Entry entry = Entry::none;
  bool joints_known = false;  ///< `hidden_by` and `taken_over_by` have been determined
  std::vector<HidingJoint> hidden_by;  ///< empty if the axis is not hidden
  /// Index of the least axis of the surfaces; -1 if the axis is not hidden.
  int taken_over_by = -1;
  int taken_over_at = -1;  ///< the corner of the joint of that surface
  bool rise_keeps_it_visible = false;
};

/// A corner and a side that may form a contact, with the result of each test.
struct Candidate {
  int corner = -1;
  PartSide side;
  double depth = 0.0;  ///< [L]
  bool inside = false, between = false, edge = false;
  bool in_notch = false;  ///< tested only if `between` is false
  bool far = false;       ///< tested only if nothing else prevents the contact
  bool acts = false;
};

/// How the choice of the axis ended.
enum class Choice {
  apart,       ///< a side separates the parts, and nothing acts
  touching,    ///< the least axis is not deeper than zero, and its contacts act
  entered,     ///< the first entered axis is not hidden, and its contacts act
  surface,     ///< a surface has taken over, and its contacts act
  inner_side,  ///< the first entered axis has an inner side, and nothing acts
  no_entry,    ///< no axis is entered, and the least one is used instead
  no_contact,  ///< nothing acts along the first entered axis; the least is used instead
  still_hidden,  ///< three axes in a row are hidden; the first entered one is used
                 ///< instead
};

/// The decision about two convex parts.
struct PartDecision {
  int part = -1, other = -1;
  Choice choice = Choice::apart;
  PartSide separating;      ///< the side that separates parts that are apart
  double separation = 0.0;  ///< [L] depth of that axis, below zero
  std::vector<Axis> axes;   ///< in ascending order of depth
  /// The first entered axis, then the surfaces that took over, as indices into axes.
  std::vector<int> path;
  int chosen = -1;  ///< an index into axes
  /// The candidates of the chosen axis. If none of those of the first entered axis
  /// acts, they are kept, and those of the axis that is used instead are appended.
  std::vector<Candidate> candidates;
};

/// The decision about two blocks.
struct PairDecision {
  std::vector<PartDecision> parts;
  /// The corner and the edge (its first corner) of each acting contact, in ascending
  /// order.
  std::vector<std::pair<int, int>> contacts;
};

/// The contact rule in exact integers.
class ExactPairRule {
 public:
  /// Copies the corners as exact integers. All coordinates must be finite. The parts
  /// have to be grouped by block, in the order of the blocks. `neighbours` lists, for
  /// each block, the blocks with which it is paired. `order` lists all blocks in the
  /// order in which the program steps them (Model::order); ties are decided in favour
  /// of the block that comes first in it. If `order` is empty, ties are decided in
  /// favour of the block with the lower number, and neighbours count in the given
  /// order.
  ExactPairRule(const Blocks& blocks, std::vector<ConvexPart> parts,
                std::vector<std::vector<int>> neighbours,
                const std::vector<int>& order = {});

  /// Decides the contacts between two different blocks. The order of a and b does not
  /// matter.
  PairDecision decide(int a, int b) const;

  /// Returns whether two sides face each other: they run against each other within ten
  /// degrees.
  bool face(const PartSide& one, const PartSide& other) const;

  /// Returns the depth of a corner below the line of an edge, [L].
  double overlap(int corner, int edge) const;

  const Blocks& blocks() const { return blocks_; }
  const std::vector<int>& neighbours(int block) const { return neighbours_[block]; }
  const std::vector<ConvexPart>& parts() const { return parts_; }

 private:
  /// A corner, by its index in a part.
  struct PartCorner {
    int part = -1, index = -1;
  };
  /// A depth 2A / L, stored as 2A and L^2, so that no root is taken.
  struct Depth {
    Whole area2, length2;
  };
  /// What bounds the depth of contacts: the least axis, and the corners of joints that
  /// are added to the vertices of the overlap region.
  struct Region {
    Depth least;
    std::vector<int> joints;
  };
  /// An interval on a side, in fractions of its length from its start. It is empty
  /// unless begin < end.
  struct Stretch {
    Ratio begin = 0, end = 0;
    bool empty() const { return begin >= end; }
    Ratio length() const { return empty() ? Ratio(0) : Ratio(end - begin); }
  };

  int size(int part) const { return static_cast<int>(parts_[part].corners.size()); }
  PartSide side(int part, int index) const;
  int number(const PartCorner& corner) const {
    return parts_[corner.part].corners[corner.index];
  }
  const Point& at(const PartCorner& corner) const { return corner_[number(corner)]; }
  PartSide side_before(const PartCorner& corner) const {
    return side(corner.part, corner.index + size(corner.part) - 1);
  }
  PartSide side_after(const PartCorner& corner) const {
    return side(corner.part, corner.index);
  }
  PartCorner start_of(const PartSide& side) const { return {side.part, side.index}; }
  PartCorner end_of(const PartSide& side) const {
    return {side.part, (side.index + 1) % size(side.part)};
  }
  Point along(const PartSide& side) const {
    return corner_[side.end] - corner_[side.start];
  }
  Whole length2(const PartSide& side) const { return dot(along(side), along(side)); }
  Whole area2(const Point& point, const PartSide& side) const {
    return cross(point - corner_[side.start], along(side));
  }
  bool outside(const Point& point, const PartSide& side) const {
    return sign(area2(point, side)) < 0;
  }
  static int compare(const Depth& a, const Depth& b);
  Depth depth_of(const Axis& axis) const;
  double rounded(const Depth& depth) const;
  double length(const PartSide& side) const;

  Axis axis_of(const PartSide& side, int other) const;
  std::vector<Axis> axes(int part, int other) const;
  std::optional<PartSide> facing_side(const Axis& axis) const;
  Entry entry(const Axis& axis) const;
  bool is_outside_part(const Point& point, int part) const;

  // These are defined in exact_choice.cpp.
  void look_for_joints(PartDecision& decision, int axis) const;
  void choose(PartDecision& decision) const;
  bool in_line(const PartSide& side, const PartSide& next) const;
  std::vector<PartSide> sides_in_line(const PartSide& side) const;
  Candidate candidate_on(const PartCorner& corner, const PartSide& side) const;
  Candidate candidate(const PartCorner& corner, const PartSide& side,
                      bool may_be_in_notch, const Region& region) const;
  Region region_of(const PartDecision& decision) const;
  void find_contacts(PartDecision& decision) const;
  void test_corner(PartDecision& decision) const;
  PartDecision decide_parts(int part, int other) const;

  // These are defined in exact_covered_side.cpp.
  Joint joint(const PartCorner& corner, const PartSide& side, int against) const;
  std::vector<Joint> closed_joints_of(const PartSide& side, int against) const;
  bool is_re_entrant(int corner) const;
  HiddenCorner hidden(const PartCorner& corner, const PartSide& from) const;
  Cover cover(const PartSide& side, bool from_start, int against) const;
  std::optional<PartSide> same_side_beyond(const PartSide& inner) const;
  bool boxes_meet(int part, int other) const;
  Stretch part_inside(const PartSide& side, int part) const;
  Stretch projection(const PartSide& f, const PartSide& g) const;
  bool touch_along(const PartSide& f, const PartSide& g) const;
  Ratio gap(const PartSide& f, const PartSide& g, const Ratio& middle) const;
  bool reaches_below(const PartSide& f, int part, const PartSide& g,
                     const Ratio& stretch) const;

  // These are defined in exact_overlap.cpp.
  /// Returns whether a depth is deeper than the overlap region of two parts and than
  /// the least axis.
  bool is_far(const Depth& depth, const Region& region, int part, int other) const;
  bool is_far(const Axis& axis, const Region& region) const;
  bool is_in_notch(const PartCorner& corner, const PartSide& side) const;

  const Blocks& blocks_;
  std::vector<ConvexPart> parts_;
  std::vector<int> first_part_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<int> rank_;  ///< (blocks) the position of each block in the order
  Lattice lattice_;
  std::vector<Point> corner_, centroid_;  ///< the centroids are those of parts
  Dyadic slack_;
};

}  // namespace blocks::audit
