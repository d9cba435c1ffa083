// For how long the decision which edge acts on a corner stands.
#pragma once

#include "dynamics/contact_groups.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Relative motion that certainly passes before a corner now outside a convex block
/// gets inside again, or its side crosses the block's (crossing_sides.hpp), [L], or 0.
/// Outside of two edges there is no crossing; outside of one while a condition of the
/// crossing keeps its sign. Seen from the block's centroid, corners move by at
/// most the relative motion u. The corner stands a gap g outside an edge's line,
/// opposite to the point (1 - q) p1 + q p2 of that line, which moves by f = |1 - q| +
/// |q| times u at most. While u (1 + f) <= 0.8 g and the edge turns by less than 0.4
/// rad (u <= 0.2 L), the corner stays outside by more than the slack.
double travel_before_contact(const Blocks& blocks, int corner, int block);

/// What certainly stands when the group is decided again, group.acting being right now.
/// Sound, so that results do not depend on it:
///
/// - Differences of two points change by the relative motion u at most, so a product
///   (scalar or vector) of two differences of lengths r and s changes by u (r + s) +
///   u^2. Being at most r s, it keeps its sign while u is below |product| / (1.5 (r +
///   s)), with a fifth of it to spare for the slack and round-off.
/// - A depth below an edge of length L changes by u + 2 u w / L at most, w the distance
///   from the edge's first corner.
/// - A candidate stays admissible, its corner inside the other edges of the block, and
///   every other record inadmissible, or deeper and too deep for a shield, for a third
///   block moves as it likes. Then nothing but the sign of its overlap is open, whether
///   the corner is inside its edge, in the slack, or beyond (where no side may cross).
/// - Without a candidate all stay inadmissible, or the corner stays outside.
/// - Corners are stored rounded: what that may add to the motion is taken off.
Certainty certainty(const Blocks& blocks, const Contacts& contacts,
                    const ContactGroup& group);

}  // namespace blocks::dynamics
