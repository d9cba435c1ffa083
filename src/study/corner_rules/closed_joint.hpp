// Closed joints in the variant `corners`. If the surface of a block continues in the
// block beside it, the side between them and its end corner are not exposed. Decided in
// doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/search/pair_index.hpp"
#include "geometry/contact_predicates.hpp"
#include "study/corner_rules/place_in_block.hpp"

namespace blocks::study::corner_rules {

/// In units of the length of the surface: the largest depth below it at which a joint
/// hides anything, and the largest distance to the block beside the joint.
inline constexpr double shielded_depth = 0.03, shielded_way = 0.06;
/// The sine of the least angle between a surface and a side of the joint. The sine of
/// the least angle between a surface and a flank (a sloping side), 1.1 degrees: a flat
/// base must feel the corners of the joint. The cosine of the largest angle between the
/// surfaces of two blocks, 18 degrees.
inline constexpr double least_slope = 0.25, least_flank = 0.02, least_cosine = 0.95;

/// In units of the depth: the distances beyond a side at which the surface is searched,
/// and the heights, up to the surface, at which the corner's block is searched.
inline constexpr std::array joint_gaps = {1.0, 0.25, 0.0625};
inline constexpr std::array joint_heights = {0.05, 0.3, 0.75, 0.97};

class ClosedJoint {
 public:
  ClosedJoint(const Blocks& blocks, const dynamics::PairIndex& index)
      : blocks_(blocks), index_(index) {}

  /// Whether the corner is shallow enough below the edge for a joint to hide anything.
  bool shallow(int c, int edge) const {
    return depth_below(c, edge) <= shielded_depth * (end(edge) - at(edge)).norm();
  }

  /// Whether edge e is hidden from corner c, which slides along the surface f. Beyond e
  /// the surface must continue in a neighbour block. The corner's own block must also
  /// lie over that block, or hold the vertex of e and f deeper than the joint is wide.
  bool hides_side(int c, int e, int f) const {
    if (!shallow(c, f))
      return false;
    const Slide slide(*this, c, e, f);
    const double depth = slide.depth;
    // The surface rarely continues, so this is tested first.
    for (const double part : joint_gaps)
      if (goes_on(slide, part * depth, true) && reaches_over(slide, part * depth))
        return true;
    const int vertex = blocks_.next[e] == f ? f : blocks_.next[f] == e ? e : -1;
    const double closed =
        vertex < 0 ? 0.0 : std::min(depth, inside_by(vertex, blocks_.corner_block[c]));
    return closed > 0.0 && goes_on(slide, closed, true);
  }

  /// Whether corner c is hidden from edge e, a flank that slopes to the surface of c's
  /// block. Beyond a side of c the surface must continue in a neighbour block. The toe
  /// (the lowest corner below the flank) must be in one of the two blocks. The joint is
  /// closed if it is narrower than the overlap of c; otherwise the flank's block must
  /// lie over it.
  bool hides_corner(int c, int e) const {
    const int before = blocks_.previous[c];
    return hidden(c, e, before, c) || hidden(c, e, c, before);
  }

 private:
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  Vec2 end(int edge) const { return at(blocks_.next[edge]); }
  Vec2 unit_along(int edge) const { return (end(edge) - at(edge)).normalized(); }
  static Vec2 outwards(const Vec2& along) { return {-along.y(), along.x()}; }
  double depth_below(int c, int edge) const {
    return geometry::cross(at(c) - at(edge), unit_along(edge));
  }
  bool holds(const Vec2& point, int block) const {
    return PlaceInBlock(blocks_).holds(point, block);
  }

  /// The depth of a corner in a convex block; 0 for other blocks.
  double inside_by(int corner, int block) const {
    if (!blocks_.convex[block])
      return 0.0;
    double least = depth_below(corner, blocks_.first_corner[block]);
    for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e)
      least = std::min(least, depth_below(corner, e));
    return least;
  }

  /// The test of `hides_corner` with one of the two edges at c as the side and the
  /// other as the surface.
  bool hidden(int c, int e, int side, int surface) const {
    if (std::abs(geometry::cross(unit_along(e), unit_along(surface))) < least_flank)
      return false;
    const int toe = toe_of(e, surface);
    if (toe < 0 || !shallow(toe, surface))
      return false;
    const Slide slide(*this, toe, side, surface);
    const double depth = slide.depth;
    if (!(depth > 0.0))
      return false;
    const double closed = std::min(depth, depth_below(c, e));
    const bool narrow = goes_on(slide, closed, true);
    const bool wide = closed < depth ? goes_on(slide, depth, true) : narrow;
    if (!narrow && !wide)
      return false;
    const bool inside = holds(at(toe), blocks_.corner_block[c]);
    return (narrow && (inside || goes_on(slide, closed, false))) ||
           (wide && inside && reaches_over(slide, depth));
  }

  /// Returns the toe of edge e: the first corner of its block that faces the surface by
  /// (20), or -1. The search starts at the end of e that is deeper below the surface.
  int toe_of(int e, int surface) const {
    const int next = blocks_.next[e];
    const bool forward = depth_below(next, surface) > depth_below(e, surface);
    const Vec2 p1 = at(surface), p2 = end(surface);
    int toe = forward ? next : e;
    for (int left = blocks_.corners_of(blocks_.corner_block[e]); left > 0; --left) {
      if (geometry::faces_edge(at(toe), at(blocks_.previous[toe]), p1, p2) &&
          geometry::faces_edge(at(toe), at(blocks_.next[toe]), p1, p2))
        return toe;
      toe = forward ? blocks_.next[toe] : blocks_.previous[toe];
    }
    return -1;
  }

  /// The geometry of corner c below a surface that ends at a side.
  struct Slide {
    int c, side, surface;
    Vec2 along;     ///< unit vector along the surface
    double depth;   ///< [L] of c below the surface
    double beyond;  ///< [L] of c below the side
    double slope;   ///< sine of the angle from the side to the surface
    double most;    ///< [L] largest useful distance along the surface

    Slide(const ClosedJoint& joint, int corner, int side_edge, int surface_edge)
        : c(corner), side(side_edge), surface(surface_edge),
          along(joint.unit_along(surface)), depth(joint.depth_below(c, surface)),
          beyond(joint.depth_below(c, side)),
          slope(geometry::cross(joint.unit_along(side), along)),
          most(shielded_way * (joint.end(surface) - joint.at(surface)).norm()) {}

    /// The distance from the corner along the surface to `gap` beyond the side, [L].
    double way(double gap) const { return (beyond + gap) / slope; }
    /// False if the side is nearly parallel to the surface or the distance is too long.
    bool possible(double way) const {
      return std::abs(slope) >= least_slope && std::abs(way) <= most;
    }
  };

  /// Whether the surface continues beyond the side in a neighbour block that is paired
  /// with the block of corner c. Unless `inside` is set, the neighbour block must hold
  /// the corner.
  bool goes_on(const Slide& slide, double gap, bool inside) const {
    const double way = slide.way(gap);
    if (!slide.possible(way))
      return false;
    const int c = slide.c, own = blocks_.corner_block[slide.side];
    const Vec2 point = at(c) + way * slide.along;
    bool found = false;
    index_.neighbours.each(blocks_.corner_block[c], [&](int third) {
      found = found ||
              (third != own && blocks_.convex[third] && near(point, third) &&
               has_surface(third, point, slide.along, slide.depth, std::abs(way)) &&
               (inside || holds(at(c), third)));
    });
    return found;
  }

  /// False only for points that are farther from the centroid than any corner.
  bool near(const Vec2& point, int block) const {
    double reach = 0.0;
    for (int c = blocks_.first_corner[block]; c < blocks_.first_corner[block + 1]; ++c)
      reach = std::max(reach, blocks_.present_arm(c).squaredNorm());
    return (point - blocks_.centroid.col(block)).squaredNorm() <= 1.1 * reach;
  }

  /// Whether the point is inside a block and about as deep below one of its edges that
  /// runs along the surface. The distance `way` must be short compared with that edge.
  bool has_surface(int block, const Vec2& point, const Vec2& surface, double depth,
                   double way) const {
    bool found = false;
    for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1];
         ++e) {
      const Vec2 edge = end(e) - at(e);
      const double product = geometry::cross(point - at(e), edge);
      if (!(product >= 0.0))
        return false;
      const double parallel = edge.dot(surface);
      if (!(parallel > 0.0))
        continue;
      const double length = edge.norm(), below = product / length;
      found |= parallel > least_cosine * length && below >= 0.5 * depth &&
               below <= 2.0 * depth && way <= shielded_way * length;
    }
    return found;
  }

  /// Whether the block of corner c lies over the place beyond the side. It is tested at
  /// several heights up to the surface, because its face may lean and its tip may be
  /// sharp.
  bool reaches_over(const Slide& slide, double gap) const {
    const double way = slide.way(gap);
    if (!slide.possible(way))
      return false;
    const Vec2 point = at(slide.c) + way * slide.along;
    const Vec2 to_surface = slide.depth * outwards(slide.along);
    for (const double part : joint_heights)
      if (reaches(blocks_.corner_block[slide.c], point + part * to_surface))
        return true;
    return false;
  }

  /// Whether a point is in a block, in rounded arithmetic.
  bool reaches(int block, const Vec2& point) const {
    if (!blocks_.convex[block])
      return holds(point, block);
    for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e)
      if (!(geometry::cross(point - at(e), end(e) - at(e)) >= 0.0))
        return false;
    return true;
  }

  const Blocks& blocks_;
  const dynamics::PairIndex& index_;
};

}  // namespace blocks::study::corner_rules
