// Two convex parts in each lane, and the margins of single questions about them
// (docs/kept-decisions.md). Included once for each instruction set.
#include "dynamics/kernels/face_kernel.hpp"
#include "dynamics/kernels/simd_lanes.hpp"
#include "geometry/contact_constants.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Larger than every depth and margin.
constexpr double never = 1e300;
using geometry::Certainty;
constexpr double slack = geometry::contact_slack;
constexpr double facing_sine = geometry::facing_sine;
constexpr double widest_joint = geometry::widest_joint;

BLOCKS_INLINE Pack min(Pack a, Pack b) { return a < b ? a : b; }
BLOCKS_INLINE Pack max(Pack a, Pack b) { return a > b ? a : b; }

/// Corner k of a part and the side that starts there.
struct FacingSide {
  Pack x, y;    ///< [L] position of the corner
  Pack ux, uy;  ///< unit vector along the side; 0 beyond the last side of the part
  Pack length;  ///< [L]
  /// How slowly a depth of the corner changes with the motion of the blocks: a motion w
  /// changes the depth by at most w / slowness.
  Pack slowness;
  Pack depth;              ///< [L] of the axis of the side
  Pack slowness_of_depth;  ///< of this depth
};

struct Part {
  FacingSide side[PartPairs::max_corners];
  Pack corners;
  Pack x, y;               ///< [L] centroid of the block
  Pack shortest, longest;  ///< [L] lengths of the shortest and of the longest side
};

BLOCKS_INLINE Pack depth_below(const FacingSide& e, Pack x, Pack y) {
  return (x - e.x) * e.uy - (y - e.y) * e.ux;
}
BLOCKS_INLINE Pack along(const FacingSide& e, Pack x, Pack y) {
  return (x - e.x) * e.ux + (y - e.y) * e.uy;
}

/// Returns the side with this index, which may differ from lane to lane.
BLOCKS_INLINE FacingSide pick(const Part& part, Pack number, int count) {
  FacingSide found = part.side[0];
  for (int k = 1; k < count; ++k) {
    const FacingSide& s = part.side[k];
    const Mask it = number == static_cast<double>(k);
    found.x = it ? s.x : found.x, found.y = it ? s.y : found.y;
    found.ux = it ? s.ux : found.ux, found.uy = it ? s.uy : found.uy;
    found.length = it ? s.length : found.length;
    found.slowness = it ? s.slowness : found.slowness;
    found.depth = it ? s.depth : found.depth;
    found.slowness_of_depth = it ? s.slowness_of_depth : found.slowness_of_depth;
  }
  return found;
}
BLOCKS_INLINE Pack before(Pack number, Pack corners) {
  return number > 0.0 ? number - 1.0 : corners - 1.0;
}
BLOCKS_INLINE Pack after(Pack number, Pack corners) {
  return number + 1.0 < corners ? number + 1.0 : Pack{};
}

/// The margin by which a value is positive, after rounding and motion.
struct Margins {
  Pack rounding;  ///< [L]
  BLOCKS_INLINE Pack of(Pack value, Pack slowness) const {
    return (value - rounding) * slowness;
  }
  /// The margin by which one depth is larger than another one.
  BLOCKS_INLINE Pack deeper(Pack one, Pack slowness, Pack other,
                            Pack other_slowness) const {
    return of(one - other, 0.5 * min(slowness, other_slowness));
  }
};

/// The angle between two sides.
struct Slope {
  Pack sine, cosine;  ///< the sine is an absolute value
  BLOCKS_INLINE Slope(const FacingSide& e, const FacingSide& f)
      : sine(absolute(e.ux * f.uy - e.uy * f.ux)), cosine(e.ux * f.ux + e.uy * f.uy) {}
  BLOCKS_INLINE Mask face() const { return (cosine < 0.0) & (sine <= facing_sine); }
  /// Returns by how much the sine exceeds `other`. If the sides do not run against each
  /// other, the result is as large as any margin needs to be.
  BLOCKS_INLINE Pack steeper_than(Pack other) const {
    return cosine < 0.0 ? sine - other : Pack{} + Certainty::opposite_sine;
  }
};

BLOCKS_INLINE void load_part(const PartPairs& pairs, const BlockState& blocks, int part,
                             int i, Part& to) {
  to.corners = load(pairs.corners[part], i);
  const Point centroid = gather_point<2>(blocks.centroid, pairs.block[part] + i);
  to.x = centroid[0], to.y = centroid[1];
  for (int k = 0; k < pairs.used_corners; ++k) {
    const Point at = gather_point<2>(blocks.corner, pairs.corner[part][k] + i);
    to.side[k].x = at[0], to.side[k].y = at[1];
  }
  to.shortest = Pack{} + never, to.longest = Pack{};
  for (int k = 0; k < pairs.used_corners; ++k) {
    FacingSide& s = to.side[k];
    const FacingSide& next = to.side[k + 1 < pairs.used_corners ? k + 1 : 0];
    const Pack x = next.x - s.x, y = next.y - s.y;
    s.length = root(x * x + y * y);
    const Mask is_side = static_cast<double>(k) < to.corners;
    const Pack per_length = is_side ? 1.0 / s.length : Pack{};
    s.ux = x * per_length, s.uy = y * per_length;
    to.shortest = is_side ? min(to.shortest, s.length) : to.shortest;
    to.longest = is_side ? max(to.longest, s.length) : to.longest;
  }
}

/// Returns the slowness of a corner with respect to the other block. A motion w changes
/// the position of the corner, seen from that block, by at most w max(1, d / 2r). Here
/// d is its distance from that block's centroid, and r is the longest arm of that
/// block.
BLOCKS_INLINE Pack slowness_of(Pack x, Pack y, const Part& other, Pack longest,
                               Pack share) {
  const Pack distance = absolute(x - other.x) + absolute(y - other.y);
  return share * min(Pack{} + 1.0, 2.0 * longest / distance);
}

/// Finds the depth of the axis of each side of `own`. Updates the least depth so far,
/// with its part and side. Returns the margin by which some side separates the parts.
BLOCKS_INLINE Pack find_axes(Part& own, const Part& other, int count,
                             const Margins& margins, Pack number_of_part, Pack& depth,
                             Pack& part, Pack& side) {
  Pack apart = Pack{} - never;
  for (int k = 0; k < count; ++k) {
    FacingSide& s = own.side[k];
    Pack deepest = Pack{} - never, slowness = {}, away = Pack{} + never;
    for (int j = 0; j < count; ++j) {
      const FacingSide& c = other.side[j];
      const Pack d = depth_below(s, c.x, c.y);
      away = min(away, margins.of(-d - slack * s.length, c.slowness));
      const Mask deeper = d > deepest;
      deepest = deeper ? d : deepest, slowness = deeper ? c.slowness : slowness;
    }
    const Mask is_side = static_cast<double>(k) < own.corners;
    s.depth = is_side ? deepest : Pack{} + never, s.slowness_of_depth = slowness;
    apart = is_side ? max(apart, away) : apart;
    const Mask less = s.depth < depth;
    depth = less ? s.depth : depth;
    part = less ? number_of_part : part;
    side = less ? Pack{} + static_cast<double>(k) : side;
  }
  return apart;
}

BLOCKS_INLINE void choose(Mask second, const Part& a, const Part& b, int count,
                          Part& to) {
  to.corners = second ? b.corners : a.corners;
  to.x = second ? b.x : a.x, to.y = second ? b.y : a.y;
  for (int k = 0; k < count; ++k) {
    const FacingSide &p = a.side[k], &q = b.side[k];
    to.side[k] = {second ? q.x : p.x,
                  second ? q.y : p.y,
                  second ? q.ux : p.ux,
                  second ? q.uy : p.uy,
                  second ? q.length : p.length,
                  second ? q.slowness : p.slowness,
                  second ? q.depth : p.depth,
                  second ? q.slowness_of_depth : p.slowness_of_depth};
  }
}

/// The two ends of a side of one part, and their depths below a side of the other part.
struct EndsBelow {
  Pack depth[2], slowness[2];
  Pack deepest;  ///< [L]
  /// Margin: the deepest corner of the part is one of the two ends.
  Pack are_deepest;

  BLOCKS_INLINE EndsBelow(const Part& part, int count, Pack start, Pack end,
                          const FacingSide& first, const FacingSide& last,
                          const FacingSide& e, const Margins& margins) {
    depth[0] = depth_below(e, first.x, first.y), slowness[0] = first.slowness;
    depth[1] = depth_below(e, last.x, last.y), slowness[1] = last.slowness;
    const Mask swapped = depth[1] > depth[0];
    deepest = swapped ? depth[1] : depth[0];
    const Pack slowness_of_deepest = swapped ? slowness[1] : slowness[0];
    are_deepest = Pack{} + never;
    for (int j = 0; j < count; ++j) {
      const FacingSide& c = part.side[j];
      const Pack number = Pack{} + static_cast<double>(j);
      const Mask other = (number != start) & (number != end) & (number < part.corners);
      const Pack margin = margins.deeper(deepest, slowness_of_deepest,
                                         depth_below(e, c.x, c.y), c.slowness);
      are_deepest = other ? min(are_deepest, margin) : are_deepest;
    }
  }
  /// Returns the margin by which an axis is deeper than both ends.
  BLOCKS_INLINE Pack less_than(Pack axis, Pack slowness_of_axis,
                               const Margins& margins) const {
    return min(margins.deeper(axis, slowness_of_axis, depth[0], slowness[0]),
               margins.deeper(axis, slowness_of_axis, depth[1], slowness[1]));
  }
};

/// The middle of what two faces have in common, on the axis side e. If f is not a face,
/// it is the foot of the corner of the axis.
struct ContactPoint {
  Pack x, y;   ///< [L]
  Pack half;   ///< [L] half the length of the common part
  Pack depth;  ///< [L] of the point of f, or of the corner, below it

  BLOCKS_INLINE ContactPoint(const FacingSide& e, const FacingSide& f,
                             const FacingSide& f_end, Mask faces) {
    // The two sides run against each other.
    const Pack high = along(e, f.x, f.y), low = along(e, f_end.x, f_end.y);
    const Pack first = max(low, Pack{}), last = min(high, e.length);
    const Pack at = faces ? 0.5 * (first + last) : high;
    const Pack on_f = faces ? (high - at) / (high - low) : Pack{};
    half = 0.5 * (last - first);
    x = e.x + at * e.ux, y = e.y + at * e.uy;
    depth = depth_below(e, f.x + on_f * (f_end.x - f.x), f.y + on_f * (f_end.y - f.y));
  }
};

/// Returns the margin by which all axes except those of two sides are deeper than the
/// two ends.
BLOCKS_INLINE Pack all_deeper(const Part& own, Pack side, const Part& other,
                              Pack facing, int count, const EndsBelow& ends,
                              const Margins& margins) {
  Pack all = Pack{} + never;
  for (int k = 0; k < count; ++k) {
    const Pack number = Pack{} + static_cast<double>(k);
    const FacingSide &s = own.side[k], &t = other.side[k];
    const Pack of_own = ends.less_than(s.depth, s.slowness_of_depth, margins);
    const Pack of_other = ends.less_than(t.depth, t.slowness_of_depth, margins);
    all = (number < own.corners) & (number != side) ? min(all, of_own) : all;
    all = (number < other.corners) & (number != facing) ? min(all, of_other) : all;
  }
  return all;
}

/// Returns the margin by which a corner is beyond an end of a side by more than the
/// slack.
BLOCKS_INLINE Pack beyond(const FacingSide& e, const FacingSide& corner,
                          const Margins& margins) {
  const Pack foot = along(e, corner.x, corner.y);
  return margins.of(max(-foot, foot - e.length) - slack * e.length, corner.slowness);
}

/// Returns the margin by which the foot of a corner is away from both ends of a long
/// side. Near its ends, the slack of a long side may exceed that of a short one.
BLOCKS_INLINE Pack off_ends(const FacingSide& e, const FacingSide& corner,
                            const Margins& margins) {
  const Pack foot = along(e, corner.x, corner.y);
  return margins.of(min(absolute(foot), absolute(foot - e.length)) -
                        Certainty::end_slacks * slack * e.length,
                    corner.slowness);
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
