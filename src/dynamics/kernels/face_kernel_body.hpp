// The computation of face_kernel.hpp. Included once for each instruction set, in a
// namespace of its own.
#include "dynamics/kernels/face_questions_body.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Decides the pairs of one pack, which begins with lane i.
BLOCKS_INLINE void find_facing_sides_of(const PartPairs& pairs,
                                        const BlockState& blocks, int i,
                                        FacingAnswers& answers) {
  const int count = pairs.used_corners;
  if (count < 3)
    __builtin_unreachable();
  const Pack share = Pack{} + (pairs.rigid ? 1.0 : Certainty::strain_share);
  Part two[2];
  Pack longest[2], farthest = {};
  for (int p = 0; p < 2; ++p) {
    load_part(pairs, blocks, p, i, two[p]);
    longest[p] = load(pairs.longest[p], i);
    farthest = max(farthest, max(absolute(two[p].x), absolute(two[p].y)) + longest[p]);
  }
  const Margins margins = {Certainty::depth_rounding * farthest};
  store(answers.rounding, i, margins.rounding);
  for (int p = 0; p < 2; ++p)
    for (int k = 0; k < count; ++k) {
      FacingSide& s = two[p].side[k];
      s.slowness = slowness_of(s.x, s.y, two[1 - p], longest[1 - p], share);
    }

  Pack depth = Pack{} + never, part = {}, side = {};
  const Pack one = Pack{} + 1.0;
  const Pack of_first =
      find_axes(two[0], two[1], count, margins, Pack{}, depth, part, side);
  const Pack of_second =
      find_axes(two[1], two[0], count, margins, one, depth, part, side);
  // There is no margin if the square of a length may overflow or underflow.
  const Mask proper = (min(two[0].shortest, two[1].shortest) > Certainty::min_length) &
                      (farthest < Certainty::max_coordinate);
  const Pack max_validity =
      proper ? Certainty::max_validity * min(longest[0], longest[1]) : Pack{} - 1.0;
  store(answers.apart, i, min(max(of_first, of_second), max_validity));
  store(answers.own, i, part);
  store(answers.side, i, side);

  Part own, other;
  const Mask second = part > 0.0;
  choose(second, two[0], two[1], count, own);
  choose(second, two[1], two[0], count, other);
  const Pack n = own.corners, m = other.corners;
  const FacingSide e = pick(own, side, count);
  const FacingSide e_before = pick(own, before(side, n), count);
  const FacingSide e_after = pick(own, after(side, n), count);

  // Find the deepest corner, and which of its two sides faces e.
  Pack corner = {}, deepest = Pack{} - never;
  for (int j = 0; j < count; ++j) {
    const Pack d = depth_below(e, other.side[j].x, other.side[j].y);
    const Mask deeper = d > deepest;
    deepest = deeper ? d : deepest;
    corner = deeper ? Pack{} + static_cast<double>(j) : corner;
  }
  corner = corner < m ? corner : Pack{};
  const Pack previous = before(corner, m);
  const FacingSide at_corner = pick(other, corner, count);
  const FacingSide at_previous = pick(other, previous, count);
  const Slope of_corner(e, at_corner), of_previous(e, at_previous);
  const Mask takes_previous =
      of_previous.face() & (~of_corner.face() | (of_previous.sine < of_corner.sine));
  const Mask faces = of_corner.face() | of_previous.face();
  const Pack facing = takes_previous ? previous : corner;
  // With a facing side f its two ends count, otherwise only the deepest corner.
  const Pack next = faces ? after(facing, m) : corner;
  const FacingSide f = pick(other, facing, count);
  const FacingSide f_before = pick(other, before(facing, m), count);
  const FacingSide f_after = pick(other, after(facing, m), count);
  const FacingSide f_end = pick(other, next, count);
  const Slope slope(e, f);

  const EndsBelow f_below(other, count, facing, next, f, f_end, e, margins);
  const EndsBelow e_below(own, count, side, after(side, n), e, e_after, f, margins);

  // An angle changes by at most the motion divided by twice the shorter longest arm.
  const Pack arm = 2.0 * min(longest[0], longest[1]) * share;
  const auto of_angle = [&](Pack value) __attribute__((always_inline)) {
    return (value - Certainty::sine_rounding) * arm;
  };
  const auto no_face = [&](const Slope& s) __attribute__((always_inline)) {
    return of_angle(s.steeper_than(Pack{} + facing_sine));
  };
  const auto steeper = [&](const FacingSide& a, const FacingSide& b)
      __attribute__((always_inline)) {
    return 0.5 * of_angle(Slope(a, b).steeper_than(slope.sine));  // both angles change
  };

  const Pack facing_or_none = faces ? facing : Pack{} - 1.0;
  const Pack others_are_deeper =
      all_deeper(own, side, other, facing_or_none, count, f_below, margins);

  // The axes of f are those of the same two faces, or they are deeper.
  const Pack same_faces =
      min(e_below.are_deepest, min(steeper(f, e_before), steeper(f, e_after)));
  const Pack f_is_deeper = f_below.less_than(f.depth, f.slowness_of_depth, margins);
  const Mask short_e = e.length < Certainty::short_side * f.length,
             short_f = f.length < Certainty::short_side * e.length;
  const Pack ends_of_e = min(off_ends(f, e, margins), off_ends(f, e_after, margins));
  const Pack ends_of_f = min(off_ends(e, f, margins), off_ends(e, f_end, margins));
  const Pack not_at_ends = short_e ? ends_of_e : (short_f ? ends_of_f : Pack{} + never);

  const ContactPoint point(e, f, f_end, faces);
  const Pack slowness = 0.5 * share;
  const Pack two_faces = min(min(of_angle(facing_sine - slope.sine),
                                 min(steeper(e, f_before), steeper(e, f_after))),
                             min(min(max(same_faces, f_is_deeper), not_at_ends),
                                 margins.of(point.half, slowness)));
  const Pack foot = along(e, f.x, f.y);
  const Pack between = margins.of(min(foot, e.length - foot), slowness);
  const Pack one_corner = min(min(no_face(of_corner), no_face(of_previous)), between);
  store(answers.faces, i,
        min(min(faces ? two_faces : one_corner, f_below.are_deepest),
            min(others_are_deeper, max_validity)));
  store(answers.facing, i, facing_or_none);
  store(answers.corner, i, corner);
  store(answers.x, i, point.x);
  store(answers.y, i, point.y);
  // The point may also be the middle on f, which is off by the sine times the mean
  // depth.
  const Pack off =
      faces ? Certainty::reach_per_half * slope.sine * slope.sine * point.half : Pack{};
  store(answers.reach, i,
        widest_joint * min(two[0].longest, two[1].longest) +
            Certainty::reach_per_depth * absolute(point.depth) + off);

  store(answers.beyond[0], i, beyond(e, f, margins));
  store(answers.beyond[1], i, beyond(e, f_end, margins));
  store(answers.beyond[2], i, beyond(f, e, margins));
  store(answers.beyond[3], i, beyond(f, e_after, margins));
}

}  // namespace

void find_facing_sides(const PartPairs& pairs, const BlockState& blocks,
                       FacingAnswers& answers) {
  for (int i = 0; i < lane_count; i += width)
    find_facing_sides_of(pairs, blocks, i, answers);
}

}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
