// For how long the decision which edge acts on a corner stands.
#pragma once

#include <array>

#include "dynamics/contact_groups.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// What certainly stands for the group, now and when it is decided again; travel 0:
/// nothing does. Sound, so that results do not depend on it:
///
/// - Differences of two points change by the relative motion u at most, so a product
///   (scalar or vector) of two differences of lengths r and s changes by u (r + s) +
///   u^2. Being at most r s, it keeps its sign while u is below |product| / (1.5 (r +
///   s)), with a fifth of it to spare for the slack and round-off.
/// - A depth below an edge of length L changes by u + 2 u w / L at most, w the distance
///   from the edge's first corner.
/// - A candidate stays admissible, nearest of its block or meeting the corner's, its
///   corner inside the other edges of the block, and
///   every other record inadmissible, or deeper and too deep for a shield, or third
///   blocks are away: they move as they like, so their ways are watched. Then nothing
///   but the sign of its overlap is open, whether the corner is inside its edge, in the
///   slack, or beyond (where no side may cross).
/// - Without a candidate all stay inadmissible; or the corner stays outside of two
///   edges, or of one that no side crosses (crossing_sides.hpp).
/// - A corner that is about to come in or to go out, such as one beside the end of an
///   edge, has little travel left. It gets more on the condition that it stays where it
///   is in the block, for a few questions take less time than a decision.
/// - Corners are stored rounded: what that may add to the motion is taken off.
///
/// block: whose edges the group's are. enough [L]: a certainty for more than that has
/// no condition; one that has is for eight times as much at most.
Certainty certainty(const Blocks& blocks, const Contacts& contacts,
                    const ContactGroups& groups, const ContactGroup& group, int block,
                    double enough);

/// For how long the condition of a group certainly holds (ContactDecision::stands).
struct ConditionTravel {
  double travel = 0.0;  ///< [L] it does; 0: whether it does now is open
  Watch watch;          ///< those which the corner may pass first, and what may cross
  double rest = 0.0;    ///< [L] it does as long as all that is watched stays as it is
};
/// enough [L]: what certainly stays as it is for this travel is not watched.
ConditionTravel condition_travel(const Blocks& blocks, const Contacts& contacts,
                                 const ContactGroup& group, int block,
                                 double enough = 0.0);

}  // namespace blocks::dynamics
