// Decides which corners of two blocks act on which edges: the contact rule
// (docs/contact-rule.md). A closed joint is not there: of the axes of two parts whose
// side is on the boundary of the union of all blocks, the one of least depth acts. The
// result depends only on the two blocks and on the blocks whose bounding boxes meet the
// grown one of one of the two. All predicates are exact. The rule is independent of the
// contact list and of the time loop.
#pragma once

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/pair_scratch.hpp"
#include "dynamics/support/groups.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// The parts of the contact rule. `blocks study` leaves out one of them to show what it
/// is for.
struct RuleParts {
  bool far_axes = true;     ///< far axes and contacts do not act
  bool third_parts = true;  ///< third parts hide axes and ends of sides
  bool faces = true;        ///< all four ends of two faces may act
};

/// Finds the contacts of blocks a and b, without duplicates (PairScratch::found), and
/// what is needed to keep the decision. neighbours: the blocks that each block is
/// paired with (each_third_part).
void decide_pair(const Blocks& blocks, const BlockParts& parts,
                 const Groups& neighbours, int a, int b, const RuleParts& rule_parts,
                 PairScratch& scratch);

}  // namespace blocks::dynamics
