// The answer of `blocks why` by the contact rule of pairs of blocks.
#pragma once

#include <string>

#include "audit/exact_pair_rule.hpp"
#include "why_scene.hpp"

namespace blocks::apps {

/// What the judge decides about two blocks, and what the file remembers of them.
struct WhyPair {
  int first = 0, second = 0;  ///< blocks, from 0
  audit::PairDecision decision;
};

WhyPair why_pair(const audit::ExactPairRule& rule, int first, int second);

/// The story of the two blocks, a line each, then the contacts that the file holds.
std::string text(const WhyPair& pair, const WhyScene& scene,
                 const audit::ExactPairRule& rule);

/// One JSON object: contacts, and for each pair of parts axes and candidates.
std::string json(const WhyPair& pair, const WhyScene& scene,
                 const audit::ExactPairRule& rule);

}  // namespace blocks::apps
