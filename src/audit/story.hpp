// Decisions about pairs of blocks in words and numbers. Blocks, corners and edges count
// from 1; an edge is named by its first corner.
#pragma once

#include <string>
#include <vector>

#include "audit/exact_pair_rule.hpp"

namespace blocks::audit {

/// "edge 3 of block 2", or "the inner side from corner 3 to corner 5 of block 2".
std::string name_of(const Blocks& blocks, const PartSide& side);

/// Why the surface does not end at a joint, or why the joint is open.
std::string words(const ExactPairRule& rule, const Joint& joint);

/// Whether an axis acts and why: "not entered: ...; does not act", "entered: ...;
/// hidden by a closed joint: ...; the surface that takes over is ...; does not act".
std::string verdict(const ExactPairRule& rule, const PartDecision& decision, int axis);

/// Whether a corner acts on a side along the chosen axis, and why not.
std::string verdict(const Candidate& candidate);

/// The whole story of two blocks, one line each: what acts, then for each pair of parts
/// the axes that the choice has used, in turn, and the contacts.
std::vector<std::string> story(const ExactPairRule& rule, int a, int b,
                               const PairDecision& decision);

}  // namespace blocks::audit
