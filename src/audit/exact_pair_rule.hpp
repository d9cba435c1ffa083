// Decides a second time which contacts act between two blocks. It follows
// docs/contact-rule.md in whole numbers, where nothing is rounded, and shares no code
// with the rule of the program (src/dynamics/rules) or its predicates.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audit/whole_numbers.hpp"
#include "model/blocks.hpp"

namespace blocks::audit {

/// An exact fraction, for places along a side.
using Ratio = boost::multiprecision::number<
    boost::multiprecision::rational_adaptor<Whole::backend_type>,
    boost::multiprecision::et_off>;

/// A convex part of a block: its corner numbers, clockwise.
struct ConvexPart {
  int block = 0;
  std::vector<int> corners;
};

/// Why these parts do not tile the block, as a sentence; empty if they do. The parts
/// tile it if they are convex, have only corners of the block, do not overlap and leave
/// nothing out. Parts without area may be missing.
std::string fault_of_parts(const Blocks& blocks, int block,
                           const std::vector<ConvexPart>& parts);

/// A side of a part, from corner number `start` to `end`, clockwise.
struct PartSide {
  int part = -1, index = -1;
  int start = -1, end = -1;
  bool inner = false;  ///< It lies between two parts of one block.
  bool operator==(const PartSide&) const = default;
};

/// Which part of a side the neighbours of a part B cover where B is.
struct Cover {
  bool covered = false;
  double stretch = 0.0;   ///< [L] from the joint to the far end of the interval
  double interval = 0.0;  ///< [L] length of the side that lies in B
  double share_of_stretch = 0.0, share_of_interval = 0.0;  ///< that is covered
  std::optional<PartSide> side;  ///< the covering side, if any side covers
};

/// A corner where a side of a part ends and a surface begins, and whether the surface
/// goes on in the block beside it.
struct Joint {
  int corner = -1;
  PartSide side, surface;
  int against_part = -1;        ///< the part that asks
  bool surface_inner = false;   ///< Then there is no surface, and the joint is open.
  bool centroid_below = false;  ///< The centroid of the asking part is inside.
  Cover cover;
  bool closed = false;
};

/// Why an axis counts as entered.
enum class Entry { none, inside, other_end, foot, crossing };

/// The closed joints that hide a corner from a side of another part.
struct HiddenCorner {
  std::vector<Joint> joints;
  bool rises = false;  ///< The surface rises beyond a closed joint at the corner.
  bool rise_keeps_it_visible = false;  ///< The side faces the rising surface.
  bool hidden() const { return !joints.empty(); }
};

/// Where a closed joint that hides an axis is: at an end of the axis side, at an end of
/// the facing side, or at the corner of the axis.
enum class HidingPlace { axis_side, facing_side, corner };

struct HidingJoint {
  HidingPlace place = HidingPlace::axis_side;
  Joint joint;
  int surface = -1;  ///< the axis of its surface, an index into PartDecision::axes
};

struct Axis {
  PartSide side;
  int corner = -1;
  int corner_part = -1, corner_index = -1;
  double depth = 0.0;  ///< [L]
  int depth_sign = 0;
  std::optional<PartSide> facing;
  bool examined = false;  ///< `entry` is known.
  Entry entry = Entry::none;
  bool looked_at = false;              ///< `hidden_by` and `taken_over_by` are known.
  std::vector<HidingJoint> hidden_by;  ///< empty: The axis is not hidden.
  int taken_over_by = -1;              ///< the least axis of the surfaces, an index
  bool rise_keeps_it_visible = false;
};

/// One pair of a corner and a side that may act, with the verdict.
struct Candidate {
  int corner = -1;
  PartSide side;
  double depth = 0.0;  ///< [L]
  bool inside = false, between = false, edge = false;
  bool acts = false;  ///< all three
};

/// How the axis was chosen.
enum class Choice {
  apart,         ///< A side keeps the parts apart, and nothing acts.
  touching,      ///< The least axis is not deeper than zero, and its contacts act.
  entered,       ///< The first entered axis is not hidden, and its contacts act.
  surface,       ///< A surface has taken over, and its contacts act.
  inner_side,    ///< The first entered axis has an inner side, and nothing acts.
  no_entry,      ///< No axis is entered, and the least one stands in.
  no_contact,    ///< Nothing acts along the first entered axis; the least stands in.
  still_hidden,  ///< Three axes in a row are hidden; the first entered one stands in.
};

struct PartDecision {
  int part = -1, other = -1;
  Choice choice = Choice::apart;
  PartSide separating;      ///< of parts that are apart
  double separation = 0.0;  ///< [L] of parts that are apart, below zero
  std::vector<Axis> axes;   ///< in the order of their depth
  /// The first entered axis, then the surfaces that took over: indices into axes.
  std::vector<int> path;
  int chosen = -1;  ///< an index into axes
  /// Those of the first entered axis are kept if nothing acts along it.
  std::vector<Candidate> candidates;
};

struct PairDecision {
  std::vector<PartDecision> parts;
  /// Corner and edge (its first corner) of each contact that acts, in ascending order.
  std::vector<std::pair<int, int>> contacts;
};

class ExactPairRule {
 public:
  /// Keeps a copy of the corners in whole numbers. All coordinates are finite. The
  /// parts of each block are beside one another, in the order of the blocks.
  /// `neighbours` has, for each block, the blocks it is paired with. `order` has the
  /// numbers of all blocks in the order in which the program steps them (Model::order);
  /// ties go to the block that comes first in it. If it is empty, they go to the block
  /// with the lower number, and neighbours count in the order given.
  ExactPairRule(const Blocks& blocks, std::vector<ConvexPart> parts,
                std::vector<std::vector<int>> neighbours,
                const std::vector<int>& order = {});

  /// What acts between two different blocks. Swapping them changes nothing.
  PairDecision decide(int a, int b) const;

  /// Whether the sides face each other. It is false for sides at an angle of more than
  /// ten degrees.
  bool face(const PartSide& one, const PartSide& other) const;

  /// Depth of a corner below an edge's line, [L].
  double overlap(int corner, int edge) const;

  const Blocks& blocks() const { return blocks_; }
  const std::vector<int>& neighbours(int block) const { return neighbours_[block]; }
  const std::vector<ConvexPart>& parts() const { return parts_; }

 private:
  /// The place of a corner in a part.
  struct PartCorner {
    int part = -1, index = -1;
  };
  /// 2A = numerator / 2, and L^2 of a side: a depth without its root.
  struct Depth {
    Whole area2, length2;
  };
  /// From the start of a side, as a part of its length: begin < end, or empty.
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

  // These are in exact_choice.cpp.
  void look_for_joints(PartDecision& decision, int axis) const;
  void choose(PartDecision& decision) const;
  bool in_line(const PartSide& side, const PartSide& next) const;
  std::vector<PartSide> sides_in_line(const PartSide& side) const;
  Candidate candidate_on(const PartCorner& corner, const PartSide& side) const;
  Candidate candidate(const PartCorner& corner, const PartSide& side) const;
  void find_contacts(PartDecision& decision) const;
  void test_corner(PartDecision& decision) const;
  PartDecision decide_parts(int part, int other) const;

  // These are in exact_covered_side.cpp.
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

  const Blocks& blocks_;
  std::vector<ConvexPart> parts_;
  std::vector<int> first_part_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<int> rank_;  ///< (blocks) the place of each block in the order
  Lattice lattice_;
  std::vector<Point> corner_, centroid_;  ///< The centroids are those of parts.
  Dyadic slack_;
};

}  // namespace blocks::audit
