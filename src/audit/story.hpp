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

/// Says whether an axis acts and why, for example "far: ..." or "hidden by
/// block 2, a third part of block 1: ...". Each string is one sentence.
std::vector<std::string> verdict(const ExactPairRule& rule,
                                 const PartDecision& decision, int axis);

/// Returns "acts", or why a corner does not act on a side of the chosen axis.
std::string verdict(const ExactPairRule& rule, const Candidate& candidate);

constexpr std::size_t story_columns = 98;  ///< so that an indented line has 100

/// Describes the decision about two blocks in lines of at most story_columns. The
/// contacts that act come first. Each pair of parts follows with the axes that were
/// examined, by depth, and the candidates for contacts.
std::vector<std::string> story(const ExactPairRule& rule, int a, int b,
                               const PairDecision& decision);

}  // namespace blocks::audit
