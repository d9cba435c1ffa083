// The answer of `blocks why`: every corner of two blocks against the other block.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "audit/exact_decision.hpp"
#include "geometry/overlap.hpp"
#include "why_scene.hpp"

namespace blocks::apps {

struct WhyReport {
  std::string file;
  std::optional<double> asked;             ///< time asked for
  int first = 0, second = 0;               ///< blocks, from 0
  std::vector<audit::Decision> decisions;  ///< corners of the first, then of the second
  std::optional<geometry::BlockOverlap> overlap;  ///< nothing: interiors do not meet
};

/// Corners of both blocks that are near the other one; none: they have no contact.
WhyReport why(const WhyScene& scene, const audit::ExactRules& rules, int first,
              int second);

std::string text(const WhyReport& report, const WhyScene& scene,
                 const audit::ExactRules& rules);
std::string json(const WhyReport& report, const WhyScene& scene,
                 const audit::ExactRules& rules);

}  // namespace blocks::apps
