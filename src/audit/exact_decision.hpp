// Which edge of a block acts on a corner, decided a second time: from the rules as
// docs/theory.md states them, in whole numbers, over all edges of the block. Shares no
// code with geometry/contact_predicates.hpp, its filters, or the contact list.
#pragma once

#include <algorithm>
#include <vector>

#include "audit/whole_numbers.hpp"
#include "model/blocks.hpp"

namespace blocks::audit {

/// `either`: the program asks this in rounded numbers, and it hangs by their rounding.
enum class Answer { no, either, yes };

/// One edge against one corner: every rule with its number, rounded, and its answer,
/// exact. n is the edge's outward normal, L its length.
struct EdgeStory {
  int edge = 0;              ///< its first corner
  double overlap = 0.0;      ///< [L] d of (19), positive inside
  double length = 0.0;       ///< [L] L
  double depth_limit = 0.0;  ///< [L] the most that the depth rule admits
  double along = 0.0;        ///< place along the edge, 0 to 1 between its corners
  double tangent_before = 0.0, tangent_after = 0.0;  ///< t.n of (20), -1 to 1
  int overlap_sign = 0;
  bool near_or_inside = false;  ///< d >= -eps L
  bool within_depth = false;    ///< d <= depth_limit
  bool between = false;         ///< -eps <= along <= 1 + eps, or in a notch beside it
  bool facing_before = false, facing_after = false;  ///< >= sin(-10 degrees)
  bool comes_through = false;  ///< no edge is nearer, or it meets the corner's block
  bool admissible = false;     ///< all that are asked
};

/// Whether a closed joint hides the nearest edge, or the corner from it (rule 7).
struct Shield {
  Answer answer = Answer::no;
  int corner = -1;     ///< that lies below the surface: the corner, or the toe in it
  int third = -1;      ///< the block in which the surface goes on
  double depth = 0.0;  ///< [L] how deep below the surface that corner lies
  double reach = 0.0;  ///< [L] how deep it may be
};

/// What is decided for a corner and the edges of one block. Edges are named by their
/// first corner, -1: none.
struct Decision {
  int corner = 0, block = 0;
  bool inside = false;  ///< the corner is inside the block, up to the slack
  /// It is outside, but a side of its block crosses a side beside the nearest edge.
  bool crossing = false;
  int nearest = -1, next = -1;  ///< admissible edges with the least depths
  Shield side;    ///< whether the nearest edge is hidden, as the side of a joint
  Shield hidden;  ///< whether the corner is hidden from it, as the corner of a joint
  int acting = -1;
  int notch = -1;             ///< acts as well: the other edge of a notch
  std::vector<int> possible;  ///< what may act, by the rounding of the joints; or -1

  bool acts(int edge) const { return edge >= 0 && (edge == acting || edge == notch); }
  /// Edge -1: that none acts.
  bool allows(int edge) const {
    return edge == acting || acts(edge) ||
           std::find(possible.begin(), possible.end(), edge) != possible.end();
  }
};

class ExactRules {
 public:
  /// The blocks as they stand: a copy of their corners in whole numbers. All
  /// coordinates finite. reach [L]: neighbours are kept for corners this far outside of
  /// a block.
  ExactRules(const Blocks& blocks, double reach);

  /// Rules 1-7 of docs/theory.md, "Which corner touches which edge".
  Decision decide(int corner, int block) const;
  /// The numbers of one edge.
  EdgeStory examine(int corner, int edge) const;
  /// Depth of a corner below an edge's line, [L].
  double overlap(int corner, int edge) const;
  /// Whether the edge of a block may act on a corner that is inside of the block.
  bool admits(int corner, int edge) const;

  /// Blocks that a corner is near to (blocks_near_corners).
  const std::vector<int>& near(int corner) const { return near_[corner]; }
  const Blocks& blocks() const { return blocks_; }

 private:
  struct Two {
    int nearest = -1, next = -1;
  };
  /// Where a corner is: inside of the block; outside of `beyond` only, if that is an
  /// edge; or neither.
  struct Place {
    bool inside = false;
    int beyond = -1;
  };
  /// From a corner along a surface to beyond a side of it.
  struct Way {
    int corner, block;    ///< the block of side and surface
    Vec2 shift, along;    ///< [L] the way; unit vector of the surface
    double depth, error;  ///< [L] of the corner below the surface; of the shift
    Answer possible;      ///< steep enough, and not too far
  };
  Point along(int edge) const;
  Whole length2(int edge) const;
  Whole area2(int corner, int edge) const;
  bool near_or_inside(int corner, int edge) const;
  bool near_or_outside(int corner, int edge) const;
  bool between(int corner, int edge) const;
  bool faces(int corner, int neighbour, int edge) const;
  bool within_depth(int corner, int edge) const;
  bool meets(int edge, int block) const;
  bool nearly_meets(int edge, int block) const;
  bool nearer_edge(int corner, int edge) const;
  bool comes_through(int corner, int edge) const;
  Place place(int corner, int block) const;
  Place place_by_rays(int corner, int block) const;
  bool rays_say_inside(int corner, int block) const;
  Vec2 halfway(int edge, int q) const;
  bool turns_inwards(int corner) const;
  int past(int corner, int edge) const;
  bool spans(int corner, int edge) const;
  int across_notch(int corner, int edge) const;
  bool steep(int from, int to, int edge, int way) const;
  bool crosses(int corner, int edge, int beyond) const;
  bool admits_crossing(int corner, int edge, int beyond) const;
  int compare_depth(int corner, int edge, int other) const;
  bool comes_before(int corner, int edge, int other) const;
  Two nearest_edges(int corner, int block, const Place& place) const;

  // exact_joint.cpp
  void look_at_joints(Decision& decision) const;
  Shield hides_side(int corner, int edge, int surface) const;
  Shield hides_corner(int corner, int edge) const;
  Shield hidden(int corner, int edge, int side, int surface) const;
  int toe_of(int edge, int surface) const;
  Shield goes_on(const Way& way, Answer inside) const;
  Answer has_surface(int block, const Way& way) const;
  Answer reaches_over(const Way& way) const;
  Answer reaches(int block, int corner, const Vec2& shift, double error) const;
  Answer shallow(int corner, int edge) const;
  Way way(int corner, int side, int surface, double gap) const;
  Vec2 rounded(const Point& difference) const;
  double roundoff(int corner, int edge) const;

  const Blocks& blocks_;
  std::vector<std::vector<int>> near_;
  Lattice lattice_;
  std::vector<Point> corner_, centroid_;
  Dyadic slack_;
};

}  // namespace blocks::audit
