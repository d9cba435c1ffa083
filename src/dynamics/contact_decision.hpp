// Which edge of a block acts on a corner (report 3.3, rules 9-12), decided exactly.
#pragma once

#include "dynamics/contact_groups.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// The record of the group that acts, or -1: the admissible edge with the least depth,
/// if the corner is inside it (rule 12). Admissible: (20) holds for both tangents of
/// the corner, the depth is at most that of the block's centroid (rule 9), and the
/// corner is between the edge's ends (rule 10), which is asked of a convex block as a
/// whole: the corner is inside all its edges (docs/departures.md).
///
/// Where a third block shields the nearest edge the next nearest acts: near a closed
/// joint a corner slides along the surface of both blocks and has not come through the
/// joint. The corner is within shield_reach of both edges, and as far out of the
/// nearest edge as the next one is deep lies the third block, or as far inwards it
/// covers the corner's own flank. Of two corners in each other's blocks, one shielded
/// is enough.
int acting_record(const Blocks& blocks, const Contacts& contacts,
                  const ContactGroups& groups, const ContactGroup& group);

/// How close to an edge of a block a corner can be shielded, [L]: a hundredth of the
/// block's shortest edge.
double shield_reach(const Blocks& blocks, int block);

}  // namespace blocks::dynamics
