// Describes decisions about pairs of blocks in words and numbers. Blocks, corners and
// edges are numbered from 1. An edge is named by its first corner.
#pragma once

#include <string>
#include <vector>

#include "audit/exact_pair_rule.hpp"

namespace blocks::audit {

/// Returns "edge 3 of block 2", or "the inner side from corner 3 to corner 5 of block
/// 2".
std::string name_of(const Blocks& blocks, const PartSide& side);

/// Says why a joint is closed, or why it is open.
std::string words(const ExactPairRule& rule, const Joint& joint);

/// Says whether an axis acts and why, for example "not entered: ...; does not act" or
/// "entered: ...; hidden by a closed joint: ...; the surface that takes over is ...;
/// does not act".
std::string verdict(const ExactPairRule& rule, const PartDecision& decision, int axis);

/// Says whether a corner on a side of the chosen axis acts, or why not.
std::string verdict(const Candidate& candidate);

/// Describes the decision about two blocks, one sentence to a line. The contacts that
/// act come first. Each pair of parts follows with the axes that the choice has used,
/// in their order, and the candidates for contacts.
std::vector<std::string> story(const ExactPairRule& rule, int a, int b,
                               const PairDecision& decision);

}  // namespace blocks::audit
