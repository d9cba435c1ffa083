// Decisions and findings in words and numbers. Blocks, corners and edges count from 1;
// an edge is named by its first corner.
#pragma once

#include <string>
#include <vector>

#include "audit/audit.hpp"

namespace blocks::audit {

/// The whole story of a corner against a block: a headline with the verdict, then a
/// line for each rule that had a say and each edge, with its numbers.
std::vector<std::string> story(const ExactRules& rules, const Decision& decision);

/// Why an edge acts or does not: "acts", "refused: ...", "farther than edge 2".
std::string verdict(const ExactRules& rules, const Decision& decision,
                    const EdgeStory& edge);

/// "corner 2 of block 5".
std::string name_of(const Blocks& blocks, int corner);

/// One line each.
std::string tell(const Blocks& blocks, const MissedPair& missed);
std::string tell(const Blocks& blocks, const WrongDecision& wrong);
std::string tell(const ExcessOverlap& excess);
std::string tell(const Blocks& blocks, const DeepContact& deep);

}  // namespace blocks::audit
