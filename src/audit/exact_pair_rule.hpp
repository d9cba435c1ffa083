// Decides independently which contacts act between two blocks. It follows
// docs/contact-rule.md in exact integers, and shares no code with the rule of the
// program (src/dynamics/rules) or its predicates.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "audit/convex_shapes.hpp"
#include "audit/exact_parts.hpp"
#include "audit/pair_decision.hpp"
#include "audit/third_part.hpp"
#include "model/blocks.hpp"

namespace blocks::audit {

/// The contact rule in exact integers.
class ExactPairRule {
 public:
  /// Copies the corners as exact integers. All coordinates must be finite. The parts
  /// have to be grouped by block, in the order of the blocks. `neighbours` lists, for
  /// each block, the blocks with which it is paired. `order` lists all blocks in the
  /// order in which the program steps them (Model::order); ties are decided in favour
  /// of the block that comes first in it. If `order` is empty, they are decided in
  /// favour of the block with the lower number.
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
  /// Two parts that overlap.
  struct Pair {
    std::array<int, 2> part;
    std::array<std::vector<int>, 2> thirds;  ///< third parts of each
    Length shift;                            ///< the separating shift
    const std::vector<int>& thirds_of(int own) const {
      return thirds[own == part[0] ? 0 : 1];
    }
  };

  int size(int part) const { return static_cast<int>(parts_[part].corners.size()); }
  PartSide side(int part, int index) const;
  PartSide side_before(const PartSide& side) const {
    return this->side(side.part, side.index + size(side.part) - 1);
  }
  PartSide side_after(const PartSide& side) const {
    return this->side(side.part, side.index + 1);
  }
  PartCorner start_of(const PartSide& side) const { return {side.part, side.index}; }
  PartCorner end_of(const PartSide& side) const {
    return {side.part, (side.index + 1) % size(side.part)};
  }
  int number(const PartCorner& corner) const {
    return parts_[corner.part].corners[corner.index];
  }
  const Point& at(const PartCorner& corner) const {
    return shape_[corner.part][corner.index];
  }
  Line line(const PartSide& side) const {
    return side_of(shape_[side.part], side.index);
  }
  Length depth_of(const Axis& axis) const {
    return line(axis.side).depth(at(axis.deepest));
  }
  ShapeAxis shapes_of(const Axis& axis) const;

  Axis axis_of(const PartSide& side, int other) const;
  std::vector<Axis> axes(int part, int other) const;
  std::optional<PartSide> facing_side(const Axis& axis) const;
  bool is_within_reach(int part, int other) const;
  std::vector<int> third_parts(int own, int other) const;
  std::optional<FarBound> far_bound(const Pair& pair, const PartCorner& corner,
                                    const PartSide& side) const;
  std::optional<FarBound> far_bound(const Pair& pair, const Axis& axis) const;
  bool is_doubtful(const PartDecision& decision) const;
  int find_carrier(const Pair& pair, const Axis& least_axis) const;
  std::vector<Blocking> blocking(const Pair& pair, const Axis& axis) const;
  void examine(const Pair& pair, Axis& axis, bool is_least) const;
  Pair pair_of(int part, int other, const Length& shift) const;
  PartDecision find_axis(int part, int other) const;
  PartDecision decide_parts(int part, int other) const;

  // These are defined in exact_contacts.cpp.
  bool in_line(const PartSide& side, const PartSide& next) const;
  std::vector<PartSide> sides_in_line(const PartSide& side) const;
  Candidate candidate_on(const PartCorner& corner, const PartSide& side) const;
  Candidate candidate(const Pair& pair, const PartCorner& corner, const PartSide& side,
                      bool may_have_no_end, bool may_be_far) const;
  void find_end(const Pair& pair, const PartCorner& corner, Candidate& found) const;
  std::vector<Candidate> candidates(const Pair& pair, const Axis& axis,
                                    bool is_least) const;

  const Blocks& blocks_;
  std::vector<ConvexPart> parts_;
  std::vector<int> first_part_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<int> rank_;  ///< (blocks) the position of each block in the order
  Lattice lattice_;
  std::vector<Shape> shape_;  ///< of each part
  Dyadic slack_;
};

}  // namespace blocks::audit
