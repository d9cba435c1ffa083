// The margins by which two faces have a common part, so that no contact is far, and by
// which a corner is not in a notch (docs/contact-rule.md#far-contacts-and-notches).
// Included once for each instruction set.
#include "dynamics/kernels/face_questions_body.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

constexpr double notch_slope = geometry::notch_slope;

/// Returns the margin by which the feet of a side's ends, on a side e that it faces,
/// and the ends of e leave a common part.
BLOCKS_INLINE Pack common_part(const FacingSide& e, const FacingSide& start,
                               const FacingSide& end, const Margins& margins) {
  const Pack last = least(e.length, along(e, start.x, start.y)),
             first = most(along(e, end.x, end.y), Pack{});
  return margins.of(0.5 * (last - first), least(start.hold, end.hold));
}

/// Returns the margin by which a corner cannot be in a notch: its foot is between the
/// ends of the side, or too far beyond one of them.
BLOCKS_INLINE Pack not_in_notch(const FacingSide& e, const FacingSide& corner,
                                const Margins& margins) {
  const Pack foot = along(e, corner.x, corner.y);
  const Pack depth = most(depth_below(e, corner.x, corner.y), Pack{});
  const Pack inside = least(foot, e.length - foot);
  return most(margins.of(inside, corner.hold),
              margins.of(-notch_slope * inside - depth, 0.5 * corner.hold));
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
