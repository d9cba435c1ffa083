// The answer of `blocks why`: what acts between two blocks, and why.
#pragma once

#include <optional>
#include <string>

#include "audit/exact_pair_rule.hpp"
#include "geometry/overlap.hpp"
#include "why_scene.hpp"

namespace blocks::apps {

struct WhyReport {
  std::string file;
  std::optional<double> asked;  ///< the time that the user has given
  int first = 0, second = 0;    ///< blocks, from 0; first < second
  audit::PairDecision decision;
  std::optional<geometry::BlockOverlap> overlap;  ///< nothing: interiors do not meet
};

/// What the judge decides about two blocks, and how they overlap.
WhyReport why(const audit::ExactPairRule& rule, int first, int second);

/// The state, the overlap, and the story of the two blocks, a line each; then the
/// contacts that the file holds.
std::string text(const WhyReport& report, const WhyScene& scene,
                 const audit::ExactPairRule& rule);

/// One JSON object: contacts, and for each pair of parts axes and candidates.
std::string json(const WhyReport& report, const WhyScene& scene,
                 const audit::ExactPairRule& rule);

}  // namespace blocks::apps
