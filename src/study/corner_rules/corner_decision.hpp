// The variant `corners`: decides which edge of a block acts on a corner. These were the
// rules of runs before the contact rule decided pairs of blocks. They are exact, with
// slack.
#pragma once

#include "dynamics/search/pair_index.hpp"
#include "study/corner_rules/closed_joint.hpp"
#include "study/corner_rules/place_in_block.hpp"

namespace blocks::study::corner_rules {

/// The decision is a pure function of the corner, the block, and the blocks that are
/// paired with the corner's block.
class CornerDecision {
 public:
  CornerDecision(const Blocks& blocks, const dynamics::PairIndex& index)
      : blocks_(blocks), place_(blocks), joint_(blocks, index) {}

  /// Returns the edge of the block that acts on corner c, or -1. It is the admissible
  /// edge with the least depth, if the corner is inside it. An edge is admissible under
  /// these conditions:
  /// - Equation (20) holds for both tangents of the corner.
  /// - The depth is at most that of the block's centroid.
  /// - The corner is inside all edges of the block, or outside one that a side of its
  ///   own block crosses.
  ///
  /// If another edge of the block is nearer, the edge must meet the corner's block. Of
  /// several edges, one that meets it comes first. ReentrantBlock has the conditions
  /// for blocks that are not convex.
  ///
  /// What closed joints hide does not act (ClosedJoint). The next nearest edge acts in
  /// place of a hidden side. It also acts in place of a flank that a hidden corner does
  /// not touch, unless it slopes too.
  int acting_edge(int c, int block) const;

  /// Returns the edge that also acts if `acting` does, because c is at a re-entrant
  /// corner of the block, or -1.
  int notch_edge(int c, int block, int acting) const;

 private:
  static constexpr int none = PlaceInBlock::none, several = PlaceInBlock::several;

  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  Vec2 end(int edge) const { return at(blocks_.next[edge]); }
  int first(int block) const { return blocks_.first_corner[block]; }
  int last(int block) const { return blocks_.first_corner[block + 1]; }
  bool reentrant(int block) const { return !blocks_.convex[block]; }
  bool inside(int c, int edge) const {
    return geometry::overlap_sign(at(c), at(edge), end(edge)) > 0;
  }
  bool nearer(int c, int edge, int other) const {
    return geometry::compare_depth(at(c), at(edge), end(edge), at(other), end(other)) <
           0;
  }

  int place(int c, int block) const;
  bool faces(int c, int edge) const;
  bool meets(int edge, int block) const;
  bool nearly_meets(int edge, int block) const;
  template <bool nearly> bool meets_convex(int edge, int block) const;
  bool meets_reentrant(int edge, int block) const;
  bool nearer_edge(int c, int edge) const;
  bool comes_through(int c, int edge) const;
  bool admissible(int c, int edge, int block) const;
  bool acts_beside_crossing(int c, int edge, int out) const;
  bool may_act(int c, int edge, int block, int out) const;
  int seen_edge(int c, int block, int out, int nearest) const;
  int depth_edge(int c, int edge) const;
  bool precedes(int c, int edge, int other) const;
  int nearest_edge(int c, int block, int out) const;
  int next_edge(int c, int block, int out, int nearest) const;

  const Blocks& blocks_;
  const PlaceInBlock place_;
  const ClosedJoint joint_;
};

}  // namespace blocks::study::corner_rules
