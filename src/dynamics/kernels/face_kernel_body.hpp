// The computation of face_kernel.hpp. Included once for each instruction set, in a
// namespace of its own.
#include "dynamics/kernels/overlap_region_body.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Decides the pairs of one pack, which begins with lane i.
BLOCKS_INLINE void find_faces_of(const PartPairs& pairs, const BlockState& blocks,
                                 int i, FacingAnswers& answers) {
  const int count = pairs.most;
  if (count < 3)
    __builtin_unreachable();
  const Pack strict = Pack{} + (pairs.rigid ? 1.0 : 0.25);
  Part two[2];
  Pack longest[2], farthest = {};
  for (int p = 0; p < 2; ++p) {
    load_part(pairs, blocks, p, i, two[p]);
    longest[p] = load(pairs.longest[p], i);
    farthest =
        most(farthest, most(absolute(two[p].x), absolute(two[p].y)) + longest[p]);
  }
  const Margins margins = {0x1p-46 * farthest};
  store(answers.rounding, i, margins.rounding);
  for (int p = 0; p < 2; ++p)
    for (int k = 0; k < count; ++k) {
      FacingSide& s = two[p].side[k];
      s.hold = hold_of(s.x, s.y, two[1 - p], longest[1 - p], strict);
    }

  Pack depth = Pack{} + never, part = {}, side = {};
  const Pack one = Pack{} + 1.0;
  const Pack of_first =
      find_axes(two[0], two[1], count, margins, Pack{}, depth, part, side);
  const Pack of_second =
      find_axes(two[1], two[0], count, margins, one, depth, part, side);
  // There is no margin if the square of a length may overflow or underflow.
  const Mask proper =
      (least(two[0].shortest, two[1].shortest) > smallest) & (farthest < largest);
  const Pack reach = proper ? 0.125 * least(longest[0], longest[1]) : Pack{} - 1.0;
  store(answers.apart, i, least(most(of_first, of_second), reach));
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
  const Pack arm = 2.0 * least(longest[0], longest[1]) * strict;
  const auto of_angle = [&](Pack value) __attribute__((always_inline)) {
    return (value - 1e-12) * arm;
  };
  const auto no_face = [&](const Slope& s) __attribute__((always_inline)) {
    return of_angle(s.steeper_than(Pack{} + facing_sine));
  };
  const auto steeper = [&](const FacingSide& a, const FacingSide& b)
      __attribute__((always_inline)) {
    return 0.5 * of_angle(Slope(a, b).steeper_than(slope.sine));  // both angles change
  };

  // Find which corners are inside the other part.
  const InsideBut start(own, count, side, after(side, n), f, margins);
  const InsideBut end(own, count, side, before(side, n), f_end, margins);
  const InsideBut e_start(other, count, facing, after(facing, m), e, margins);
  const InsideBut e_end(other, count, facing, before(facing, m), e_after, margins);
  const Pack facing_or_none = faces ? facing : Pack{} - 1.0;
  const Pack deeper_than_e =
      all_deeper(own, side, other, facing_or_none, count, f_below, margins);
  const Pack deeper_than_f =
      all_deeper(own, side, other, facing_or_none, count, e_below, margins);

  // The axes of f are those of the same two faces, or they are deeper.
  const Pack same_faces =
      least(e_below.are_deepest, least(steeper(f, e_before), steeper(f, e_after)));
  const Pack f_is_deeper = f_below.less_than(f.depth, f.hold_of_depth, margins);
  const Pack entered_inside =
      least(least(most(start.all(), f_below.is_not_deepest[0]),
                  most(end.all(), f_below.is_not_deepest[1])),
            least(deeper_than_e, most(same_faces, f_is_deeper)));
  const Pack e_in_turn = least(most(start.others, f_below.is_not_deepest[0]),
                               most(end.others, f_below.is_not_deepest[1]));
  const Pack f_in_turn = least(most(e_start.others, e_below.is_not_deepest[0]),
                               most(e_end.others, e_below.is_not_deepest[1]));
  const Pack entered_in_turn = least(least(most(e_in_turn, f_in_turn), same_faces),
                                     least(deeper_than_e, deeper_than_f));
  const Mask short_e = e.length < 0.2 * f.length, short_f = f.length < 0.2 * e.length;
  const Pack ends_of_e = least(off_ends(f, e, margins), off_ends(f, e_after, margins));
  const Pack ends_of_f = least(off_ends(e, f, margins), off_ends(e, f_end, margins));
  const Pack not_at_ends = short_e ? ends_of_e : (short_f ? ends_of_f : Pack{} + never);
  // Nothing along the two faces is far if they have a common part or e has the least
  // axis.
  const Pack are_near = most(f_is_deeper, common_part(e, f, f_end, margins));
  const Pack two_faces =
      least(least(of_angle(facing_sine - slope.sine),
                  least(steeper(e, f_before), steeper(e, f_after))),
            least(least(most(entered_inside, entered_in_turn), not_at_ends), are_near));
  const Pack one_corner = least(least(least(no_face(of_corner), no_face(of_previous)),
                                      least(start.all(), deeper_than_e)),
                                not_in_notch(e, f, margins));
  store(answers.faces, i,
        least(least(faces ? two_faces : one_corner, f_below.are_deepest), reach));
  store(answers.facing, i, facing_or_none);
  store(answers.corner, i, corner);

  // A joint is open if the centroid of the other part is inside its surface.
  const auto inside = [&](const FacingSide& surface, const Part& of, Pack hold)
      __attribute__((always_inline)) {
    return margins.of(depth_below(surface, of.x, of.y), hold);
  };
  const Pack own_longest = second ? longest[1] : longest[0];
  const Pack other_longest = second ? longest[0] : longest[1];
  const Pack hold_of_other = hold_of(other.x, other.y, own, own_longest, strict);
  const Pack hold_of_own = hold_of(own.x, own.y, other, other_longest, strict);
  store(answers.joint[0], i, inside(e_before, other, hold_of_other));
  store(answers.joint[1], i, inside(e_after, other, hold_of_other));
  store(answers.joint[2], i, inside(f_before, own, hold_of_own));
  const Pack at_f_after = inside(f_after, own, hold_of_own);
  const Pack at_corner_side = inside(at_corner, own, hold_of_own);
  store(answers.joint[3], i, faces ? at_f_after : at_corner_side);

  store(answers.beyond[0], i, beyond(e, f, margins));
  store(answers.beyond[1], i, beyond(e, f_end, margins));
  store(answers.beyond[2], i, beyond(f, e, margins));
  store(answers.beyond[3], i, beyond(f, e_after, margins));
}

}  // namespace

void find_faces(const PartPairs& pairs, const BlockState& blocks,
                FacingAnswers& answers) {
  for (int i = 0; i < lane_count; i += width)
    find_faces_of(pairs, blocks, i, answers);
}

}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
